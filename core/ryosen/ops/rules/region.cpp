#include "ryosen/ops/rules/region.h"

#include <algorithm>
#include <cstdint>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/rings.h"

namespace ryosen {

Region::Region(const Mesh& mesh, std::span<const Face> faces) {
  for (Face f : faces)
    if (set_.insert(f).second) faces_.push_back(f);
  find_border(mesh);
  std::unordered_set<Vertex> met;
  for (Face f : faces_)
    for (Vertex v : vertices_around(mesh, f))
      if (met.insert(point(mesh, v)).second) points_.push_back(point(mesh, v));
  for (Vertex p : points_)
    if (!staying_.contains(p) && is_held(mesh, p)) staying_.insert(p);
}

void Region::find_border(const Mesh& mesh) {
  std::unordered_set<std::uint64_t> met;  // pairs of points
  for (Face f : faces_)
    for (Halfedge h : halfedges_around(mesh, f)) {
      if (is_bridge(mesh, h)) continue;
      const auto [low, high] = std::minmax({point(mesh, mesh.from(h)).index, point(mesh, mesh.to(h)).index});
      if (met.insert(std::uint64_t{low} << 32 | high).second) add_border(mesh, h);
    }
}

void Region::add_border(const Mesh& mesh, Halfedge side) {
  std::size_t ours = 0, others = 0;
  const auto count = [&](Halfedge sheet) {
    for (Halfedge h : {sheet, twin(sheet)})
      if (!mesh.is_outside(h)) ++(contains(mesh.face(h)) ? ours : others);
  };
  const Vertex a = mesh.from(side), b = mesh.to(side);
  if (!has_copies(mesh, a) && !has_copies(mesh, b)) {
    count(side);
  } else {
    for (Halfedge sheet : sheets_between(mesh, a, b)) count(sheet);
  }
  if (others == 0 && ours > 1) return;
  border_.push_back({side, ours > 1});
  staying_.insert({point(mesh, a), point(mesh, b)});
}

bool Region::is_held(const Mesh& mesh, Vertex p) const {
  return any_of_copies(mesh, p, [&](Vertex copy) {
    for (Halfedge h : outgoing(mesh, copy))
      if (mesh.is_wire(edge(h)) || (!mesh.is_outside(h) && !contains(mesh.face(h)))) return true;
    return false;
  });
}

bool Region::stays_behind(const Mesh& mesh, Vertex v) const { return staying_.contains(point(mesh, v)); }

}  // namespace ryosen
