#include "core/algo/repair/near_points.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>
#include <unordered_map>

#include "core/geometry/is_finite.h"
#include "core/mesh/circulate.h"
#include "core/mesh/copies.h"

namespace ryosen {

namespace {

struct CellHash {
  std::size_t operator()(const std::array<double, 3>& cell) const {
    std::uint64_t hash = 0;
    for (double x : cell) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 32u;
    }
    return hash;
  }
};

// A hash grid for radius queries. Cells are slightly wider than twice the radius, so per axis a neighbour is in the
// same cell or in the adjacent one on the nearer side.
class NearPoints {
 public:
  NearPoints(const Mesh& mesh, double distance) : mesh_(mesh), distance_(distance), width_(distance * 2.001) {}

  // The lowest point added that is within the distance, or none.
  Vertex first_near(const glm::dvec3& p) const {
    std::array<Interval, 3> cells;
    for (int axis = 0; axis < 3; ++axis) cells[static_cast<std::size_t>(axis)] = cells_near(p[axis]);
    Vertex best;
    for (const double x : cells[0].cells())
      for (const double y : cells[1].cells())
        for (const double z : cells[2].cells()) {
          const auto cell = cells_.find({x, y, z});
          if (cell == cells_.end()) continue;
          for (Vertex first : cell->second)
            if ((!best || first < best) && is_near(p, mesh_.position(first))) best = first;
        }
    return best;
  }
  void add(Vertex first) {
    const glm::dvec3& p = mesh_.position(first);
    cells_[{cell_of(p.x), cell_of(p.y), cell_of(p.z)}].push_back(first);
  }

 private:
  struct Interval {
    std::array<double, 2> numbers{};
    std::size_t count = 1;
    std::span<const double> cells() const { return {numbers.data(), count}; }
  };

  // + 0.0 turns -0 into 0.
  double cell_of(double x) const { return width_ > 0 ? std::floor(x / width_) + 0.0 : x + 0.0; }
  Interval cells_near(double x) const {
    const double cell = cell_of(x);
    if (!(width_ > 0)) return {{cell, cell}, 1};
    return {{cell, (x / width_ - cell < 0.5 ? cell - 1 : cell + 1) + 0.0}, 2};
  }
  bool is_near(const glm::dvec3& p, const glm::dvec3& q) const {
    return distance_ > 0 ? glm::distance(p, q) <= distance_ : p == q;
  }

  const Mesh& mesh_;
  double distance_, width_;
  std::unordered_map<std::array<double, 3>, std::vector<Vertex>, CellHash> cells_;
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

std::vector<Vertex> first_points_within(const Mesh& m, const std::vector<Vertex>& point_of, double distance,
                                        std::span<const Vertex> used_elsewhere) {
  const auto stays_in_file = [&](Vertex v) {
    return std::binary_search(used_elsewhere.begin(), used_elsewhere.end(), v) && is_isolated_point(m, v);
  };
  std::vector<Vertex> first(m.vertex_slots());
  NearPoints near(m, distance);
  for (std::uint32_t i = 0; i < m.vertex_slots(); ++i) {
    const Vertex v(i);
    if (point_of[i] != v) continue;
    first[i] = v;
    if (!is_finite(m.position(v)) || ends_a_wire(m, v)) continue;
    if (const Vertex other = near.first_near(m.position(v)))
      first[i] = other;
    else if (!stays_in_file(v))
      near.add(v);
  }
  return first;
}

}  // namespace ryosen
