#include "ryosen/analysis/components.h"

#include "ryosen/analysis/disjoint_sets.h"
#include "ryosen/base/interruption.h"

namespace ryosen {

namespace {

DisjointSets join_faces(Neighbourhood& around) {
  const Mesh& mesh = around.mesh();
  DisjointSets sets(mesh.face_slots());
  std::vector<Face> faces;
  for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
    stop_if_interrupted();
    const Edge e(i);
    if (!mesh.is_alive(e)) continue;
    const Face f = mesh.face(halfedge(e, 0)), g = mesh.face(halfedge(e, 1));
    if (f && g) sets.join(f.index, g.index);
    if (!mesh.has_copies() || around.is_single_sheet(halfedge(e)) || !around.is_first_sheet(e)) continue;
    around.faces_at(halfedge(e), faces);
    for (Face other : faces) sets.join(faces[0].index, other.index);
  }
  return sets;
}

// Union-find with parity: whether each face must be flipped relative to the root of its set.
class TurnSets {
 public:
  explicit TurnSets(std::uint32_t faces) : parent_(faces), turned_(faces, false) {
    for (std::uint32_t i = 0; i < faces; ++i) parent_[i] = i;
  }
  // Records that exactly one of the two must be flipped (`against`), or none or both. False on contradiction.
  bool join(std::uint32_t f, std::uint32_t g, bool against) {
    const auto [root_f, turn_f] = root(f);
    const auto [root_g, turn_g] = root(g);
    const bool turn = (turn_f != turn_g) != against;
    if (root_f == root_g) return !turn;
    parent_[root_g] = root_f;
    turned_[root_g] = turn;
    return true;
  }

 private:
  std::pair<std::uint32_t, bool> root(std::uint32_t i) {
    std::uint32_t top = i;
    bool turn = false;
    for (; parent_[top] != top; top = parent_[top]) turn = turn != turned_[top];
    // Path compression.
    for (bool rest = turn; parent_[i] != top && i != top;) {
      const std::uint32_t up = parent_[i];
      const bool own = turned_[i];
      parent_[i] = top;
      turned_[i] = rest;
      rest = rest != own;
      i = up;
    }
    return {top, turn};
  }

  std::vector<std::uint32_t> parent_;
  std::vector<bool> turned_;  // parity relative to the parent
};

}  // namespace

std::uint32_t count_face_components(Neighbourhood& around) {
  const Mesh& mesh = around.mesh();
  return join_faces(around).count() - (mesh.face_slots() - mesh.live().faces);
}

FaceComponents find_face_components(Neighbourhood& around) {
  const Mesh& mesh = around.mesh();
  DisjointSets sets = join_faces(around);
  FaceComponents components;
  components.of_face.assign(mesh.face_slots(), no_index);
  for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
    stop_if_interrupted();
    if (!mesh.is_alive(Face(i))) continue;
    const std::uint32_t root = sets.root(i);  // the lowest face, so it is visited first
    components.of_face[i] = root == i ? components.count++ : components.of_face[root];
  }
  return components;
}

bool is_orientable(Neighbourhood& around) { return !find_twist(around); }

Halfedge find_twist(Neighbourhood& around) {
  const Mesh& mesh = around.mesh();
  TurnSets sets(mesh.face_slots());
  for (std::uint32_t i = 0; i < mesh.halfedge_slots(); ++i) {
    stop_if_interrupted();
    const Halfedge h(i);
    if (!mesh.is_alive(h) || mesh.is_outside(h)) continue;
    const Halfedge other = around.across(h);
    if (!other || other < h) continue;
    if (!sets.join(mesh.face(h).index, mesh.face(other).index, around.edge(h).is_misoriented())) return h;
  }
  return Halfedge();
}

}  // namespace ryosen
