// How a simplifier removes parts of the surface that are smaller than the error.
#include <algorithm>
#include <utility>

#include "ryosen/algo/simplify/simplifier.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/mesh/rings.h"

namespace ryosen {

namespace {

struct SmallPart {
  double size;  // the diagonal of its box, scaled
  std::vector<Vertex> vertices;
};

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

// The components whose size is at most that, smallest first. Those with a wire, a ring, or a vertex that something
// keeps in its place are none. O(n).
std::vector<SmallPart> find_small_parts(const CollapseSurface& surface, double largest) {
  const Mesh& mesh = surface.mesh();
  std::vector<std::uint8_t> is_seen(mesh.vertex_slots());
  const auto see = [&](Vertex v) { return std::exchange(is_seen[v.index], std::uint8_t{1}) == 0; };
  std::vector<SmallPart> parts;
  for (const Vertex v : live_vertices(mesh)) {
    if (mesh.is_isolated(v) || is_seen[v.index]) continue;
    std::optional<SmallPart> part = walk_part(surface, v, mesh.vertex_slots(), see);
    if (part && part->size <= largest) parts.push_back(std::move(*part));
  }
  std::stable_sort(parts.begin(), parts.end(), [](const SmallPart& a, const SmallPart& b) { return a.size < b.size; });
  return parts;
}

// The one of a vertex, whatever its size; none where it may not go as a whole, or has more vertices than parts have
// that are too small to collapse. O(1).
std::optional<SmallPart> find_small_part(const CollapseSurface& surface, Vertex first) {
  constexpr std::size_t most_vertices = 16;
  std::vector<Vertex> seen;
  return walk_part(surface, first, most_vertices, [&](Vertex v) {
    if (std::find(seen.begin(), seen.end(), v) != seen.end()) return false;
    seen.push_back(v);
    return true;
  });
}

bool is_larger(const std::pair<double, Vertex>& a, const std::pair<double, Vertex>& b) {
  return a.first != b.first ? a.first > b.first : a.second.index > b.second.index;
}

}  // namespace

void Simplifier::note_small_part(Halfedge h) {
  const std::optional<SmallPart> part = find_small_part(surface_, mesh_.from(h));
  if (!part) return;
  noted_parts_.emplace_back(part->size, part->vertices.front());
  std::push_heap(noted_parts_.begin(), noted_parts_.end(), is_larger);
}

// One may have been noted several times, and may have collapsed further since.
void Simplifier::remove_noted_parts() {
  while (!is_at_goal() && !noted_parts_.empty() && noted_parts_.front().first <= small_size()) {
    std::pop_heap(noted_parts_.begin(), noted_parts_.end(), is_larger);
    const Vertex v = noted_parts_.back().second;
    noted_parts_.pop_back();
    if (!mesh_.is_alive(v)) continue;
    const std::optional<SmallPart> part = find_small_part(surface_, v);
    if (part && part->size <= small_size()) remove_part(part->vertices);
  }
}

void Simplifier::remove_small_parts() {
  for (const SmallPart& part : find_small_parts(surface_, small_size())) {
    if (is_at_goal()) return;
    remove_part(part.vertices);
  }
}

// The vertices with the edges and faces at them.
void Simplifier::remove_part(std::span<const Vertex> part) {
  if (steps_) edit_.emplace(writable_, steps_);
  std::vector<Edge> edges;
  for (Vertex v : part)
    for (Halfedge h : outgoing(mesh_, v)) {
      if (const Face f = mesh_.face(h); f && mesh_.is_alive(f)) {
        if (crossing_guard_) crossing_guard_->forget(f);
        edit_->drop(f);
      }
      if (h < twin(h)) edges.push_back(edge(h));
    }
  for (Edge e : edges) edit_->drop(e);
  for (Vertex v : part) edit_->drop(v);
  if (steps_) {
    edit_->commit();
    edit_.reset();
  }
  ++removed_parts_;
}

}  // namespace ryosen
