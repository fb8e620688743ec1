#include "ryosen/algo/repair/near_points.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>

#include "ryosen/algo/repair/point_merger.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"

namespace ryosen {

namespace {

// A hash grid for radius queries. Cells are slightly wider than twice the radius, so per axis a neighbour is in the
// same cell or in the adjacent one on the nearer side. Cells of one hash share a list; what is far is told by its
// place.
class PointGrid {
 public:
  PointGrid(const Mesh& mesh, double distance)
      : mesh_(mesh),
        distance_(distance),
        width_(distance * 2.001),
        first_(std::bit_ceil(std::size_t{2} * mesh.vertex_slots() + 1), no_index),
        next_(mesh.vertex_slots(), no_index) {}

  // The lowest point added that is within the distance, or none.
  Vertex first_near(const glm::dvec3& p) const {
    std::array<Interval, 3> cells;
    for (int axis = 0; axis < 3; ++axis) cells[static_cast<std::size_t>(axis)] = cells_near(p[axis]);
    std::uint32_t best = no_index;
    for (const double x : cells[0].cells())
      for (const double y : cells[1].cells())
        for (const double z : cells[2].cells())
          for (std::uint32_t i = first_[slot_of({x, y, z})]; i != no_index; i = next_[i])
            if (i < best && is_near(p, mesh_.position(Vertex(i)))) best = i;
    return best == no_index ? Vertex() : Vertex(best);
  }
  void add(Vertex v) {
    const glm::dvec3& p = mesh_.position(v);
    std::uint32_t& first = first_[slot_of({cell_of(p.x), cell_of(p.y), cell_of(p.z)})];
    next_[v.index] = first;
    first = v.index;
  }

 private:
  struct Interval {
    std::array<double, 2> numbers{};
    std::size_t count = 1;
    std::span<const double> cells() const { return {numbers.data(), count}; }
  };

  // + 0.0 turns -0 into 0. Where there are too many cells for a double, only what is equal is near.
  double cell_of(double x) const {
    const double cell = width_ > 0 ? std::floor(x / width_) : x;
    return (std::isfinite(cell) ? cell : x) + 0.0;
  }
  Interval cells_near(double x) const {
    const double cell = cell_of(x);
    if (!(width_ > 0)) return {{cell, cell}, 1};
    return {{cell, (x / width_ - cell < 0.5 ? cell - 1 : cell + 1) + 0.0}, 2};
  }
  std::size_t slot_of(const glm::dvec3& cell) const {
    std::uint64_t hash = 0;
    for (int axis = 0; axis < 3; ++axis) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(cell[axis])) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 32u;
    }
    return hash & (first_.size() - 1);
  }
  bool is_near(const glm::dvec3& p, const glm::dvec3& q) const {
    return distance_ > 0 ? glm::distance(p, q) <= distance_ : p == q;
  }

  const Mesh& mesh_;
  double distance_, width_;
  std::vector<std::uint32_t> first_, next_;  // by hash of cells, by point: vertices
};

}  // namespace

bool ends_a_wire(const Mesh& m, Vertex p) {
  bool found = false;
  for_each_copy(m, p, [&](Vertex copy) {
    if (m.is_boundary(copy))
      for (Edge e : edges_around(m, copy)) found = found || m.is_wire(e);
  });
  return found;
}

bool is_isolated_point(const Mesh& m, Vertex p) {
  return !any_of_copies(m, p, [&](Vertex copy) { return !m.is_isolated(copy); });
}

bool NearPoints::are_any() const {
  for (std::uint32_t i = 0; i < first.size(); ++i)
    if (first[i] && first[i] != Vertex(i)) return true;
  return false;
}

NearPoints find_near_points(const Mesh& m, const Reach& reach) {
  const auto stays_in_file = [&](Vertex v) {
    return std::binary_search(reach.used.begin(), reach.used.end(), v) && is_isolated_point(m, v);
  };
  const auto may_be_near = [&](std::uint32_t i) { return !reach.only || (i < reach.only->size() && (*reach.only)[i]); };
  NearPoints near{points_by_slot(m), std::vector<Vertex>(m.vertex_slots())};
  PointGrid grid(m, reach.distance);
  for (std::uint32_t i = 0; i < m.vertex_slots(); ++i) {
    const Vertex v(i);
    if (near.point_of[i] != v) continue;
    near.first[i] = v;
    if (!may_be_near(i) || !is_finite(m.position(v)) || ends_a_wire(m, v)) continue;
    if (const Vertex other = grid.first_near(m.position(v)))
      near.first[i] = other;
    else if (!stays_in_file(v))
      grid.add(v);
  }
  return near;
}

}  // namespace ryosen
