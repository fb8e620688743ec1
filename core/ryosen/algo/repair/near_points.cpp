#include "ryosen/algo/repair/near_points.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "ryosen/algo/repair/sound_changes.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/ops/collapse_edge.h"

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

// Grows a point by collapsing its edges to near points onto it, so that a collapse moves only the faces of the point
// that goes: the other way round, those of a point that has taken up many would be moved again and again.
std::size_t grow(Edit& edit, Vertex grown, const std::vector<Vertex>& place, Progress& progress) {
  const Mesh& m = edit.mesh();
  const auto is_way = [&](Halfedge h) {
    const Vertex end = point(m, m.to(h));
    return grown < end && place[end.index] == place[grown.index];
  };
  const auto ways_from = [&](Vertex from) {
    std::vector<Halfedge> ways;
    for_each_copy(m, from, [&](Vertex copy) {
      if (m.is_isolated(copy)) return;
      for (Halfedge h : outgoing(m, copy))
        if (is_way(h)) ways.push_back(h);
    });
    return ways;
  };
  std::vector<Halfedge> ways = ways_from(grown), refused;
  std::size_t done = 0;
  for (int round = 0; round < 2 && !ways.empty(); ++round) {  // what was refused may be sound once others are gone
    const std::size_t before = done;
    for (std::size_t i = 0; i < ways.size() && progress.go_on(); ++i) {
      const Halfedge way = ways[i];
      if (!m.is_alive(way) || !is_way(way)) continue;
      if (!collapses_soundly(m, twin(way))) {
        refused.push_back(way);
        continue;
      }
      const std::vector<Halfedge> further = ways_from(m.to(way));  // of the end, they become the point's
      CollapseEdge{twin(way), CollapseEdge::Place::end}.apply(edit);
      std::copy_if(further.begin(), further.end(), std::back_inserter(ways), [&](Halfedge h) { return m.is_alive(h); });
      ++done;
    }
    if (done == before) break;
    ways = std::exchange(refused, {});
  }
  return done;
}

}  // namespace

bool ends_a_wire(const Mesh& m, Vertex p) {
  return any_of_copies(m, p, [&](Vertex copy) {
    const auto edges = edges_around(m, copy);
    return m.is_boundary(copy) && std::any_of(edges.begin(), edges.end(), [&](Edge e) { return m.is_wire(e); });
  });
}

bool is_isolated_point(const Mesh& m, Vertex p) {
  return !any_of_copies(m, p, [&](Vertex copy) { return !m.is_isolated(copy); });
}

NearPoints find_near_points(const Mesh& m, const Reach& reach) {
  const auto stays_in_file = [&](Vertex v) {
    return std::binary_search(reach.used.begin(), reach.used.end(), v) && is_isolated_point(m, v);
  };
  const auto may_be_near = [&](std::uint32_t i) { return !reach.only || (i < reach.only->size() && (*reach.only)[i]); };
  NearPoints near{std::vector<Vertex>(m.vertex_slots())};
  PointGrid grid(m, reach.distance);
  for (const Vertex v : live_vertices(m)) {
    const Vertex p = point(m, v);
    near.first[v.index] = p == v ? v : near.first[p.index];
    if (p != v || !may_be_near(v.index) || !is_finite(m.position(v)) || ends_a_wire(m, v)) continue;
    if (const Vertex other = grid.first_near(m.position(v))) {
      near.first[v.index] = other;
      near.are_any = true;
    } else if (!stays_in_file(v)) {
      grid.add(v);
    }
  }
  return near;
}

std::size_t collapse_near(Edit& edit, const NearPoints& near, Progress& progress) {
  const Mesh& m = edit.mesh();
  std::size_t done = 0;
  for (std::uint32_t i = 0; i < m.vertex_slots() && progress.go_on(i, m.vertex_slots()); ++i)
    if (const Vertex p(i); m.is_alive(p) && point(m, p) == p) done += grow(edit, p, near.first, progress);
  return done;
}

}  // namespace ryosen
