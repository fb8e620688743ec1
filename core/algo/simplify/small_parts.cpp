#include "core/algo/simplify/small_parts.h"

#include <algorithm>

#include "core/mesh/circulate.h"
#include "core/mesh/rings.h"

namespace ryosen {

namespace {

// The component of a vertex; without a size where it cannot go.
class PartWalk {
 public:
  explicit PartWalk(const CollapseSurface& surface)
      : surface_(surface), mesh_(surface.mesh()), is_seen_(mesh_.vertex_slots()) {}

  bool is_seen(Vertex v) const { return is_seen_[v.index]; }

  SmallPart walk(Vertex first, bool& may_go) {
    SmallPart part{0, {first}};
    Box box;
    may_go = true;
    is_seen_[first.index] = 1;
    for (std::size_t i = 0; i < part.vertices.size(); ++i) {
      const Vertex v = part.vertices[i];
      box.add(surface_.place(v));
      may_go = may_go && surface_.is_free(v);
      for (Halfedge h : outgoing(mesh_, v)) {
        may_go = may_go && !mesh_.is_wire(edge(h)) && (mesh_.is_outside(h) || !mesh_.has_rings(mesh_.face(h)));
        if (is_seen_[mesh_.to(h).index]) continue;
        is_seen_[mesh_.to(h).index] = 1;
        part.vertices.push_back(mesh_.to(h));
      }
    }
    part.size = glm::length(box.highest - box.lowest);
    return part;
  }

 private:
  const CollapseSurface& surface_;
  const Mesh& mesh_;
  std::vector<std::uint8_t> is_seen_;
};

}  // namespace

std::vector<SmallPart> find_small_parts(const CollapseSurface& surface, double largest) {
  const Mesh& mesh = surface.mesh();
  PartWalk walk(surface);
  std::vector<SmallPart> parts;
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
    const Vertex v(i);
    if (!mesh.is_alive(v) || mesh.is_isolated(v) || walk.is_seen(v)) continue;
    bool may_go = false;
    SmallPart part = walk.walk(v, may_go);
    if (may_go && part.size <= largest) parts.push_back(std::move(part));
  }
  std::stable_sort(parts.begin(), parts.end(), [](const SmallPart& a, const SmallPart& b) { return a.size < b.size; });
  return parts;
}

void remove_part(Edit& edit, const std::vector<Vertex>& vertices) {
  const Mesh& mesh = edit.mesh();
  std::vector<Edge> edges;
  for (Vertex v : vertices)
    for (Halfedge h : outgoing(mesh, v)) {
      if (const Face f = mesh.face(h); f && mesh.is_alive(f)) edit.remove(f);
      if (h < twin(h)) edges.push_back(edge(h));
    }
  for (Edge e : edges) edit.remove(e);
  for (Vertex v : vertices) edit.remove(v);
}

}  // namespace ryosen
