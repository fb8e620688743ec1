#include "ryosen/ops/rules/manifold_points.h"

#include <algorithm>
#include <array>

#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/rings.h"

namespace ryosen {

ManifoldPoints::Side ManifoldPoints::side_of(Halfedge h) const {
  const Vertex a = point(mesh(), mesh().from(h)), b = point(mesh(), mesh().to(h));
  return {std::min(a, b), std::max(a, b), a < b};
}

PointEdge& ManifoldPoints::faces_at(const Side& side) {
  const auto [edge, is_new] = edges_.try_emplace(std::uint64_t{side.low.index} << 32 | side.high.index);
  PointEdge& faces = edge->second;
  if (!is_new) return faces;
  const Mesh& m = mesh();
  const std::array<std::uint32_t, 2> ends{side.low.index, side.high.index};
  const bool is_low = loneliest_point(m, ends) == side.low;
  for (Halfedge h : sheets_between(m, is_low ? side.low : side.high, is_low ? side.high : side.low)) {
    faces.forward += !m.is_outside(is_low ? h : twin(h));
    faces.backward += !m.is_outside(is_low ? twin(h) : h);
  }
  return faces;
}

void ManifoldPoints::loses(Face f) {
  const Mesh& m = mesh();
  if (!m.has_copies()) return;
  for (const Halfedge h : halfedges_around(m, f)) {
    const Vertex v = m.from(h);
    points_.push_back(point(m, v));
    if (!m.is_boundary(v)) opened_.emplace_back(v, points_.back());
    if (!has_copies(m, v) && !has_copies(m, m.to(h))) continue;  // at most one face is left there
    sides_.push_back(side_of(h));
    faces_at(sides_.back());
  }
}

// Whether an edge at the vertex, whose fan has a gap now, is to be cut. A copy may have taken the number of its point.
bool ManifoldPoints::opens_an_edge(Vertex v, Vertex p) const {
  const Mesh& m = mesh();
  if (!m.is_alive(v)) return m.is_alive(p) && opens_an_edge(p, p);
  if (m.is_isolated(v)) return false;
  for (const Halfedge h : outgoing(m, v))
    if (!m.is_outside(h) && !m.is_outside(twin(h)) && is_cut_on_points(m, h)) return true;
  return false;
}

bool ManifoldPoints::is_manifold_where_lost() {
  for (const Side& side : sides_) {
    PointEdge& faces = faces_at(side);
    --(side.is_forward ? faces.forward : faces.backward);
  }
  const bool has_pair = std::any_of(sides_.begin(), sides_.end(), [&](const Side& side) {
    const PointEdge& faces = faces_at(side);
    return faces.forward == 1 && faces.backward == 1;
  });
  if (has_pair) return false;
  return std::none_of(opened_.begin(), opened_.end(),
                      [&](const auto& at) { return opens_an_edge(at.first, at.second); });
}

void ManifoldPoints::make_manifold() {
  sort_unique(points_);
  std::vector<Vertex> others;
  for (const Vertex p : points_)
    if (!manifold_.contains(p)) others.push_back(p);
  if (is_manifold_where_lost() && sheets_.is_manifold(others)) {
    manifold_.insert(others.begin(), others.end());
  } else {
    for (const Vertex v : sheets_.make_manifold(points_))
      if (mesh().is_alive(v)) manifold_.erase(point(mesh(), v));
  }
  sides_.clear();
  points_.clear();
  opened_.clear();
}

}  // namespace ryosen
