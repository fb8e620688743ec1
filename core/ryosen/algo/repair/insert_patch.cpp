#include "ryosen/algo/repair/insert_patch.h"

#include "ryosen/ops/rules/corner_values.h"
#include "ryosen/ops/rules/surgery.h"

namespace ryosen {

namespace {

class PatchInserter {
 public:
  PatchInserter(Edit& edit, const HoleLoop& hole, const HolePatch& patch) : edit_(edit), hole_(hole), patch_(patch) {}

  void run() {
    for (std::uint32_t i = 0; i < hole_.size(); ++i) {
      vertices_.push_back(mesh().from(hole_.sides[i]));
      halfedges_[key(i, (i + 1) % hole_.size())] = hole_.sides[i];
    }
    loop_ = vertices_;
    for (std::uint32_t v = patch_.corners; v < patch_.places.size(); ++v) add_vertex(v);
    for (const CornerTriangle& t : patch_.triangles) add_triangle(t);
    for (Vertex v : loop_) hold_outside(edit_, v);
  }

 private:
  const Mesh& mesh() const { return edit_.mesh(); }
  static std::uint64_t key(std::uint32_t a, std::uint32_t b) { return std::uint64_t{a} << 32u | b; }

  void add_vertex(std::uint32_t v) {
    const Vertex vertex = edit_.add_vertex(patch_.places[v]);
    const CornerTriangle& parents = patch_.parents[v - patch_.corners];
    if (parents[0] == no_index) {
      mean_vertex_values(edit_, loop_, vertex);
    } else {
      const std::array<Vertex, 3> from{vertices_[parents[0]], vertices_[parents[1]], vertices_[parents[2]]};
      mean_vertex_values(edit_, from, vertex);
    }
    vertices_.push_back(vertex);
  }

  Halfedge side(std::uint32_t a, std::uint32_t b) {
    if (const auto known = halfedges_.find(key(a, b)); known != halfedges_.end()) return known->second;
    const Halfedge h = edit_.add_edge(vertices_[a], vertices_[b]);
    halfedges_[key(a, b)] = h;
    halfedges_[key(b, a)] = twin(h);
    if (a >= patch_.corners) edit_.set_halfedge(vertices_[a], h);
    if (b >= patch_.corners) edit_.set_halfedge(vertices_[b], twin(h));
    return h;
  }

  void add_triangle(const CornerTriangle& t) {
    const std::array<Halfedge, 3> h{side(t[0], t[1]), side(t[1], t[2]), side(t[2], t[0])};
    const Face f = edit_.add_face(h[0]);
    for (std::size_t k = 0; k < 3; ++k) {
      edit_.connect(h[k], h[(k + 1) % 3]);
      edit_.set_face(h[k], f);
    }
    copy_face_values(edit_, mesh().face(twin(hole_.sides[0])), f);
  }

  Edit& edit_;
  const HoleLoop& hole_;
  const HolePatch& patch_;
  std::vector<Vertex> vertices_, loop_;
  std::unordered_map<std::uint64_t, Halfedge> halfedges_;
};

}  // namespace

void insert_patch(Edit& edit, const HoleLoop& hole, const HolePatch& patch) { PatchInserter(edit, hole, patch).run(); }

}  // namespace ryosen
