#include "ryosen/algo/simplify/small_parts.h"

#include <algorithm>
#include <utility>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/rings.h"

namespace ryosen {

namespace {

// The component of a vertex, of which no other vertex is seen yet; none where it may not go or has more than so many
// vertices. `see(v)` tells whether v had not been seen, and has by then.
template <class See>
std::optional<SmallPart> walk_part(const CollapseSurface& surface, Vertex first, std::size_t most, See see) {
  const Mesh& mesh = surface.mesh();
  SmallPart part{0, {first}};
  Box box;
  bool may_go = see(first);
  for (std::size_t i = 0; i < part.vertices.size(); ++i) {
    if (part.vertices.size() > most) return std::nullopt;
    const Vertex v = part.vertices[i];
    box.add(surface.place(v));
    may_go = may_go && surface.is_free(v);
    for (Halfedge h : outgoing(mesh, v)) {
      may_go = may_go && !mesh.is_wire(edge(h)) && (mesh.is_outside(h) || !mesh.has_rings(mesh.face(h)));
      if (see(mesh.to(h))) part.vertices.push_back(mesh.to(h));
    }
  }
  part.size = glm::length(box.highest - box.lowest);
  return may_go ? std::optional(std::move(part)) : std::nullopt;
}

}  // namespace

std::vector<SmallPart> find_small_parts(const CollapseSurface& surface, double largest) {
  const Mesh& mesh = surface.mesh();
  std::vector<std::uint8_t> is_seen(mesh.vertex_slots());
  const auto see = [&](Vertex v) { return std::exchange(is_seen[v.index], std::uint8_t{1}) == 0; };
  std::vector<SmallPart> parts;
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
    const Vertex v(i);
    if (!mesh.is_alive(v) || mesh.is_isolated(v) || is_seen[i]) continue;
    std::optional<SmallPart> part = walk_part(surface, v, mesh.vertex_slots(), see);
    if (part && part->size <= largest) parts.push_back(std::move(*part));
  }
  std::stable_sort(parts.begin(), parts.end(), [](const SmallPart& a, const SmallPart& b) { return a.size < b.size; });
  return parts;
}

std::optional<SmallPart> find_small_part(const CollapseSurface& surface, Vertex first) {
  constexpr std::size_t most_vertices = 16;
  std::vector<Vertex> seen;
  return walk_part(surface, first, most_vertices, [&](Vertex v) {
    if (std::find(seen.begin(), seen.end(), v) != seen.end()) return false;
    seen.push_back(v);
    return true;
  });
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
