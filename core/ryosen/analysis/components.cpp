#include "ryosen/analysis/components.h"

#include "ryosen/analysis/disjoint_sets.h"
#include "ryosen/base/interruption.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen {

namespace {

DisjointSets join_faces(Neighbourhood& around) {
  const Mesh& mesh = around.mesh();
  DisjointSets sets(mesh.face_slots());
  std::vector<Face> faces;
  for (const Edge e : live_edges(mesh)) {
    stop_if_interrupted();
    const Face f = mesh.face(halfedge(e, 0)), g = mesh.face(halfedge(e, 1));
    if (f && g) sets.join(f.index, g.index);
    if (!mesh.has_copies() || around.is_single_sheet(halfedge(e)) || !around.is_first_sheet(e)) continue;
    around.faces_at(halfedge(e), faces);
    for (Face other : faces) sets.join(faces[0].index, other.index);
  }
  return sets;
}

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
  for (const Face f : live_faces(mesh)) {
    stop_if_interrupted();
    const std::uint32_t root = sets.root(f.index);  // the lowest face, so it is visited first
    components.of_face[f.index] = root == f.index ? components.count++ : components.of_face[root];
  }
  return components;
}

bool is_orientable(Neighbourhood& around) { return !find_twist(around); }

Halfedge find_twist(Neighbourhood& around) {
  const Mesh& mesh = around.mesh();
  // Each face as it is and, behind all faces, turned over: what is in one set stays together.
  const std::uint32_t faces = mesh.face_slots();
  DisjointSets sets(2 * std::size_t{faces});
  for (const Halfedge h : live_halfedges(mesh)) {
    stop_if_interrupted();
    if (mesh.is_outside(h)) continue;
    const Halfedge other = around.across(h);
    if (!other || other < h) continue;
    const std::uint32_t f = mesh.face(h).index, g = mesh.face(other).index;
    const bool against = around.edge(h).is_misoriented();
    const std::uint32_t with_f = against ? faces + g : g, with_turned_f = against ? g : faces + g;
    if (sets.root(f) == sets.root(with_turned_f)) return h;
    sets.join(f, with_f);
    sets.join(faces + f, with_turned_f);
  }
  return Halfedge();
}

}  // namespace ryosen
