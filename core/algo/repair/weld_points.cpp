#include "core/algo/repair/weld_points.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>
#include <unordered_map>

#include "core/algo/repair/detach_nonmanifold.h"
#include "core/analysis/equal_faces.h"
#include "core/base/count_text.h"
#include "core/geometry/is_finite.h"
#include "core/mesh/circulate.h"
#include "core/mesh/copies.h"
#include "core/ops/collapse_edge.h"
#include "core/ops/rules/sheets.h"

namespace ryosen {

namespace {

// Points to merge, ascending; the first keeps its number and position.
using Group = std::vector<Vertex>;

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

  // The lowest group whose first point is within the distance, or no_index.
  std::uint32_t group_near(const glm::dvec3& p) const {
    std::array<Interval, 3> cells;
    for (int axis = 0; axis < 3; ++axis) cells[static_cast<std::size_t>(axis)] = cells_near(p[axis]);
    std::uint32_t best = no_index;
    for (const double x : cells[0].cells())
      for (const double y : cells[1].cells())
        for (const double z : cells[2].cells()) {
          const auto cell = cells_.find({x, y, z});
          if (cell == cells_.end()) continue;
          for (std::uint32_t g : cell->second)
            if (g < best && is_near(p, mesh_.position(firsts_[g]))) best = g;
        }
    return best;
  }
  void add_group(Vertex first) {
    const glm::dvec3& p = mesh_.position(first);
    cells_[{cell_of(p.x), cell_of(p.y), cell_of(p.z)}].push_back(static_cast<std::uint32_t>(firsts_.size()));
    firsts_.push_back(first);
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
  std::vector<Vertex> firsts_;
  std::unordered_map<std::array<double, 3>, std::vector<std::uint32_t>, CellHash> cells_;
};

bool ends_a_wire(const Mesh& m, Vertex p) {
  bool found = false;
  for_each_copy(m, p, [&](Vertex copy) {
    if (m.is_boundary(copy))
      for (Edge e : edges_around(m, copy)) found = found || m.is_wire(e);
  });
  return found;
}

std::vector<Group> groups_within(const Mesh& m, double distance) {
  std::vector<Group> groups;
  NearPoints near(m, distance);
  for (std::uint32_t i = 0; i < m.vertex_slots(); ++i) {
    const Vertex v(i);
    if (!m.is_alive(v) || point(m, v) != v || !is_finite(m.position(v)) || ends_a_wire(m, v)) continue;
    if (const std::uint32_t g = near.group_near(m.position(v)); g != no_index) {
      groups[g].push_back(v);
    } else {
      near.add_group(v);
      groups.push_back({v});
    }
  }
  std::erase_if(groups, [](const Group& g) { return g.size() < 2; });
  return groups;
}

template <class Visit>
void for_each_face_at(const Mesh& m, Vertex p, Visit visit) {
  for_each_copy(m, p, [&](Vertex copy) {
    for (Face f : faces_around(m, copy))
      if (f) visit(f);
  });
}

bool has_two_points_of_a_face(const Mesh& m, const Group& group) {
  bool found = false;
  for (Vertex p : group)
    for_each_face_at(m, p, [&](Face f) {
      for (Vertex v : vertices_around(m, f)) {
        const Vertex q = point(m, v);
        found = found || (q != p && std::binary_search(group.begin(), group.end(), q));
      }
    });
  return found;
}

std::size_t drop_groups_within_faces(const Mesh& m, std::vector<Group>& groups) {
  return std::erase_if(groups, [&](const Group& group) { return has_two_points_of_a_face(m, group); });
}

// Makes all vertices of a group copies of one point.
void unite(Edit& edit, Sheets& sheets, const Group& group) {
  const Mesh& m = edit.mesh();
  std::vector<Vertex> copies;
  for (Vertex p : group) for_each_copy(m, p, [&](Vertex copy) { copies.push_back(copy); });
  const glm::dvec3 place = m.position(group[0]);
  for (std::size_t i = 0; i < copies.size(); ++i) {
    if (m.position(copies[i]) != place) sheets.changed_around(copies[i]);
    edit.set_position(copies[i], place);
  }
  link_copies(edit, copies);
  for (Vertex copy : copies)
    if (m.is_isolated(copy) && has_copies(m, copy)) sheets.remove_vertex(copy);
}

void weld_groups(Edit& edit, const std::vector<Group>& groups) {
  Sheets sheets(edit);
  std::vector<Vertex> points;
  for (const Group& group : groups) {
    unite(edit, sheets, group);
    points.push_back(group[0]);
  }
  sheets.settle(points);
}

// Welds, then splits points that became non-manifold, fan by fan. Returns the number of points split off.
std::size_t weld_soundly(Edit& edit, const std::vector<Group>& groups) {
  weld_groups(edit, groups);
  std::vector<Vertex> points;
  for (const Group& group : groups) points.push_back(group[0]);
  return detach_points(edit, std::move(points));
}

std::size_t drop_nonmanifold(const Mesh& m, std::vector<Group>& groups) {
  Neighbourhood around(m, Neighbourhood::Reach::whole);
  const auto is_nonmanifold = row_of(ProblemKind::nonmanifold_vertex).vertex;
  return std::erase_if(groups, [&](const Group& group) {
    return std::any_of(group.begin(), group.end(), [&](Vertex p) { return is_nonmanifold(around, p); });
  });
}

bool is_before(const glm::dvec3& p, const glm::dvec3& q) {
  return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
}

// The corner positions of duplicate faces that are not in `before`; ascending.
std::vector<glm::dvec3> places_of_duplicates(const Mesh& m, const std::vector<std::uint32_t>& before) {
  Neighbourhood around(m, Neighbourhood::Reach::whole);
  std::vector<glm::dvec3> places;
  for (std::uint32_t f : find_duplicate_faces(around)) {
    if (std::binary_search(before.begin(), before.end(), f)) continue;
    for (Vertex v : vertices_around(m, Face(f))) places.push_back(m.position(v));
  }
  std::sort(places.begin(), places.end(), is_before);
  return places;
}

// Drops the groups whose weld would create a non-manifold edge or duplicate faces, by trial on a copy. Each round drops
// at least one.
std::size_t drop_unsound(const Mesh& m, std::vector<Group>& groups, Progress& progress) {
  Neighbourhood around(m, Neighbourhood::Reach::whole);
  const std::vector<std::uint32_t> before = find_duplicate_faces(around);
  std::size_t dropped = 0;
  constexpr int most_rounds = 12;
  for (int round = 0; !groups.empty() && progress.go_on(static_cast<std::size_t>(round), most_rounds); ++round) {
    Mesh trial = m;
    Edit edit(trial, nullptr);
    weld_groups(edit, groups);
    edit.commit();
    const std::vector<glm::dvec3> places = places_of_duplicates(trial, before);
    Neighbourhood welded(trial, Neighbourhood::Reach::whole);
    const std::size_t now = std::erase_if(groups, [&](const Group& g) {
      return std::binary_search(places.begin(), places.end(), m.position(g[0]), is_before) ||
             welded.star(g[0]).has_nonmanifold_edge;
    });
    dropped += now;
    if (now == 0) break;
    if (round == most_rounds) {  // give up rather than create a defect
      dropped += groups.size();
      groups.clear();
    }
  }
  return dropped;
}

AlgorithmResult result_of(std::size_t welded, std::size_t left) {
  AlgorithmResult result{welded, left, {}};
  result.text = count_text(welded, "One point was welded to another", "# points were welded to others",
                           "点を # 個、ほかの点に統合しました");
  if (left > 0) {
    result.text.en += "; " + std::to_string(left) + (left == 1 ? " place was left apart" : " places were left apart");
    result.text.ja += "（統合できない箇所 " + std::to_string(left) + "）";
  }
  result.text.en += ".";
  result.text.ja += "。";
  return result;
}

// Collapses edges between points of one group; the lower number stays.
void collapse_within(Edit& edit, const std::vector<Group>& groups, Progress& progress) {
  const Mesh& m = edit.mesh();
  std::size_t done = 0;
  for (const Group& group : groups) {
    if (!progress.go_on(done++, groups.size())) return;
    for (std::size_t i = group.size(); i-- > 1;) {
      if (!m.is_alive(group[i])) continue;
      std::vector<Halfedge> ways;
      for_each_copy(m, group[i], [&](Vertex copy) {
        if (m.is_isolated(copy)) return;
        for (Halfedge h : outgoing(m, copy))
          if (std::binary_search(group.begin(), group.end(), point(m, m.to(h)))) ways.push_back(h);
      });
      std::sort(ways.begin(), ways.end(),
                [&](Halfedge a, Halfedge b) { return point(m, m.to(a)) < point(m, m.to(b)); });
      for (Halfedge h : ways) {
        const CollapseEdge op{h, CollapseEdge::Place::end};
        if (point(m, m.to(h)) > group[i] || !op.check(m).legal() || op.directed(m) != h) continue;
        op.apply(edit);
        break;
      }
    }
  }
}

}  // namespace

AlgorithmResult weld_equal_points(Edit& edit, const AlgorithmInput&, Progress& progress) {
  const Mesh& m = edit.mesh();
  std::size_t welded = 0, left = 0;
  for (bool goes_on = true; goes_on;) {
    std::vector<Group> groups = groups_within(m, 0);
    left = drop_groups_within_faces(m, groups) + drop_nonmanifold(m, groups) + drop_unsound(m, groups, progress);
    if (progress.is_cancelled()) return {};
    const std::uint32_t before = counts_on_points(m).vertices;
    left += weld_soundly(edit, groups);
    const std::uint32_t now = before - counts_on_points(m).vertices;
    welded += now;
    goes_on = now > 0 && left > 0;  // a group may no longer be blocked
  }
  return result_of(welded, left);
}

AlgorithmResult weld_close_points(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  const Mesh& m = edit.mesh();
  const double distance = input.values.length("distance");
  const std::uint32_t before = counts_on_points(m).vertices;
  collapse_within(edit, groups_within(m, distance), progress);
  if (progress.is_cancelled()) return {};
  std::vector<Group> groups = groups_within(m, distance);
  const std::size_t left = drop_groups_within_faces(m, groups);
  weld_groups(edit, groups);
  return result_of(before - counts_on_points(m).vertices, left);
}

}  // namespace ryosen
