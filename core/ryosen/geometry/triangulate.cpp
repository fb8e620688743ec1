#include "ryosen/geometry/triangulate.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "ryosen/geometry/is_finite.h"
#include "ryosen/geometry/polygon_normal.h"
#include "ryosen/geometry/predicates.h"
#include "ryosen/geometry/sweep.h"

namespace ryosen {

namespace {

using Polygon = std::span<const glm::dvec3>;
using Triangles = std::vector<CornerTriangle>;

// Up to this many corners ear clipping draws self-intersecting polygons better; above, it takes too long.
constexpr std::size_t most_corners_for_ears = 1024;

// The projection along one axis in which the polygon is counter-clockwise. Coordinates are copied or negated, never
// rounded.
struct View {
  int axis = 2;
  bool mirrored = false;

  glm::dvec2 operator()(const glm::dvec3& p) const {
    const glm::dvec2 seen = seen_along(p, axis);
    return mirrored ? glm::dvec2(-seen.x, seen.y) : seen;
  }
};

// The axes by descending magnitude of the normal's component.
std::array<View, 3> views_of(const glm::dvec3& normal) {
  std::array<View, 3> views = {View{2, normal.z < 0.0}, View{1, normal.y < 0.0}, View{0, normal.x < 0.0}};
  const auto share = [&](const View& view) { return std::abs(normal[view.axis]); };
  std::stable_sort(views.begin(), views.end(), [&](const View& a, const View& b) { return share(a) > share(b); });
  return views;
}

void add_fan(std::uint32_t count, Triangles& out) {
  for (std::uint32_t i = 1; i + 1 < count; ++i) out.push_back({0, i, i + 1});
}

// The orientation signs of a quad's four corners in the first projection where any is nonzero, negated if most are
// negative: a simple quad has at most one reflex corner.
std::array<int, 4> quad_turns(Polygon quad) {
  std::array<int, 4> turns{};
  for (const View view : views_of(polygon_normal(quad))) {
    const std::array<glm::dvec2, 4> p = {view(quad[0]), view(quad[1]), view(quad[2]), view(quad[3])};
    int sum = 0;
    bool any = false;
    for (std::size_t i = 0; i < 4; ++i) {
      turns[i] = orient2d(p[(i + 3) % 4], p[i], p[(i + 1) % 4]);
      sum += turns[i];
      any = any || turns[i] != 0;
    }
    if (sum < 0)
      for (int& turn : turns) turn = -turn;
    if (any) break;
  }
  return turns;
}

// A quad is cut by its shorter diagonal, or by the one that lies inside.
void triangulate_quad(Polygon quad, Triangles& out) {
  const std::array<int, 4> turns = quad_turns(quad);
  const int first = std::min(turns[1], turns[3]);   // corners opposite diagonal 0-2
  const int second = std::min(turns[0], turns[2]);  // corners opposite diagonal 1-3
  bool use_first = first >= second;
  if (first > 0 && second > 0) {
    const glm::dvec3 a = quad[2] - quad[0];
    const glm::dvec3 b = quad[3] - quad[1];
    use_first = glm::dot(a, a) <= glm::dot(b, b);
  }
  if (use_first)
    out = {{0, 1, 2}, {0, 2, 3}};
  else
    out = {{0, 1, 3}, {1, 2, 3}};
}

constexpr std::size_t most_point_tests = 20'000'000;

// Ear clipping: the fallback for polygons that the sweep cannot triangulate (self-intersecting, flat or empty).
//
// Appends size - 2 triangles of the closed corner list `corners` (numbers into `points`), ears first; if there is no
// ear, it cuts the next convex corner, or else any. Terminates: after a fixed number of point tests (about 0.3 s) the
// rest becomes a fan. Deterministic. O(n²) and worse within that limit.
class EarClipper {
 public:
  EarClipper(std::span<const glm::dvec2> points, std::span<const std::uint32_t> corners)
      : points_(points), corners_(corners) {
    const auto count = static_cast<std::uint32_t>(corners.size());
    next_.resize(count);
    prev_.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) {
      next_[i] = i + 1 < count ? i + 1 : 0;
      prev_[next_[i]] = i;
    }
  }

  void run(std::vector<CornerTriangle>& out) {
    auto left = static_cast<std::uint32_t>(corners_.size());
    std::uint32_t here = 0, refused = 0;
    while (left > 3 && tests_ < most_point_tests) {
      if (refused < left ? is_ear(here) : (refused >= 2 * left || bend(here) > 0)) {
        cut(here, out);
        --left;
        refused = 0;
        here = next_[next_[here]];  // skipping one corner keeps fans from growing around a single corner
      } else {
        ++refused;
        here = next_[here];
      }
    }
    // The rest: normally one triangle; a fan if the budget of point tests ran out.
    for (; left > 2; --left) cut(next_[here], out);
  }

 private:
  const glm::dvec2& point(std::uint32_t place) const { return points_[corners_[place]]; }
  int bend(std::uint32_t i) const { return orient2d(point(prev_[i]), point(i), point(next_[i])); }

  bool is_ear(std::uint32_t i) {
    ++tests_;
    if (bend(i) <= 0) return false;
    const glm::dvec2 &a = point(prev_[i]), &b = point(i), &c = point(next_[i]);
    for (std::uint32_t k = next_[next_[i]]; k != prev_[i]; k = next_[k]) {
      ++tests_;
      const glm::dvec2& p = point(k);
      if (p == a || p == b || p == c) continue;
      if (orient2d(a, b, p) >= 0 && orient2d(b, c, p) >= 0 && orient2d(c, a, p) >= 0) return false;
    }
    return true;
  }

  // Emits the triangle at a corner and unlinks the corner; its own links stay, so a caller can walk on from it.
  void cut(std::uint32_t i, std::vector<CornerTriangle>& out) {
    out.push_back({corners_[prev_[i]], corners_[i], corners_[next_[i]]});
    next_[prev_[i]] = next_[i];
    prev_[next_[i]] = prev_[i];
  }

  std::span<const glm::dvec2> points_;
  std::span<const std::uint32_t> corners_;
  std::vector<std::uint32_t> next_, prev_;
  std::size_t tests_ = 0;
};

class Triangulator {
 public:
  void run(Triangles& out) {
    out.clear();
    const auto count = static_cast<std::uint32_t>(corners_.size());
    if (count < 3) return;
    if (!std::all_of(corners_.begin(), corners_.end(), [](const auto& p) { return is_finite(p); }))
      return fill(count, out);
    const auto views = views_of(polygon_normal(Polygon(corners_).first(ends_[0])));
    for (View view : views) {
      project(view);
      if (!turn_counter_clockwise(view)) continue;
      if (ends_.size() == 1 && is_strictly_convex()) return add_fan(count, out);
      if (sweep_triangles({points_, ends_}, SweepMode::strict, out)) return;
      out.clear();
    }
    project(views[0]);
    if (count > most_corners_for_ears && sweep_triangles({points_, ends_}, SweepMode::tolerant, out)) return;
    out.clear();
    join_loops();
    EarClipper(points_, joined_).run(out);
  }

  void take(std::span<const Polygon> loops) {
    corners_.clear();
    ends_.clear();
    for (const Polygon loop : loops) {
      if (loop.empty()) continue;
      corners_.insert(corners_.end(), loop.begin(), loop.end());
      ends_.push_back(static_cast<std::uint32_t>(corners_.size()));
    }
  }

 private:
  void project(const View& view) {
    points_.resize(corners_.size());
    std::transform(corners_.begin(), corners_.end(), points_.begin(), view);
  }

  // Decides by the outer loop's highest point, where a simple polygon is convex, and mirrors the projection if needed;
  // false if the loop is edge-on (all collinear) in it.
  bool turn_counter_clockwise(View& view) {
    const std::span<const glm::dvec2> outer(points_.data(), ends_[0]);
    const auto is_higher = [](const glm::dvec2& p, const glm::dvec2& q) { return p.y != q.y ? p.y > q.y : p.x < q.x; };
    const glm::dvec2 top = *std::min_element(outer.begin(), outer.end(), is_higher);
    const std::size_t count = outer.size();
    int turn = 0;
    for (std::size_t i = 0; i < count && turn == 0; ++i) {
      if (outer[i] != top) continue;
      std::size_t before = (i + count - 1) % count;
      std::size_t after = (i + 1) % count;
      while (before != i && outer[before] == top) before = (before + count - 1) % count;
      while (after != i && outer[after] == top) after = (after + 1) % count;
      turn = orient2d(outer[before], outer[i], outer[after]);
    }
    if (turn < 0) {
      view.mirrored = !view.mirrored;
      project(view);
    }
    return turn != 0 || !is_on_edge();
  }

  bool is_on_edge() const {
    for (std::size_t i = 2; i < ends_[0]; ++i)
      if (orient2d(points_[0], points_[i - 1], points_[i]) != 0) return false;
    return true;
  }

  // Left turns only, and winds once: then a fan has no degenerate or inverted triangle.
  bool is_strictly_convex() const {
    const std::size_t count = points_.size();
    int direction_changes = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const glm::dvec2 &a = points_[i], &b = points_[(i + 1) % count], &c = points_[(i + 2) % count];
      if (orient2d(a, b, c) <= 0) return false;
      const bool falls = a.y > b.y || (a.y == b.y && a.x < b.x);
      const bool falls_next = b.y > c.y || (b.y == c.y && b.x < c.x);
      direction_changes += falls != falls_next;
    }
    return direction_changes == 2;
  }

  // One corner list through all loops, each hole joined to the nearest corner so far by a bridge.
  void join_loops() {
    joined_.clear();
    for (std::uint32_t i = 0; i < ends_[0]; ++i) joined_.push_back(i);
    for (std::size_t loop = 1; loop < ends_.size(); ++loop) {
      const std::uint32_t first = ends_[loop - 1];
      const glm::dvec2 p = points_[first];
      const auto distance = [&](std::uint32_t corner) { return glm::distance(points_[corner], p); };
      const auto nearest = std::min_element(
          joined_.begin(), joined_.end(), [&](std::uint32_t a, std::uint32_t b) { return distance(a) < distance(b); });
      std::vector<std::uint32_t> bridge = {*nearest};
      for (std::uint32_t i = first; i < ends_[loop]; ++i) bridge.push_back(i);
      bridge.push_back(first);
      joined_.insert(nearest, bridge.begin(), bridge.end());
    }
  }

  // Triangles for non-finite corners: only their count and corner use are meaningful.
  void fill(std::uint32_t count, Triangles& out) {
    points_.assign(count, glm::dvec2(0.0));
    join_loops();
    const auto fan_start = out.size();
    add_fan(static_cast<std::uint32_t>(joined_.size()), out);
    for (std::size_t i = fan_start; i < out.size(); ++i)
      for (std::uint32_t& corner : out[i]) corner = joined_[corner];
  }

  std::vector<glm::dvec3> corners_;
  std::vector<std::uint32_t> ends_;
  std::vector<glm::dvec2> points_;
  std::vector<std::uint32_t> joined_;
};

}  // namespace

void triangulate(std::span<const glm::dvec3> polygon, std::vector<CornerTriangle>& out) {
  out.clear();
  if (polygon.size() < 3) return;
  if (polygon.size() == 3) {
    out.push_back({0, 1, 2});
    return;
  }
  if (polygon.size() == 4 && std::all_of(polygon.begin(), polygon.end(), [](const auto& p) { return is_finite(p); }))
    return triangulate_quad(polygon, out);
  triangulate_loops({&polygon, 1}, out);
}

void triangulate_loops(std::span<const std::span<const glm::dvec3>> loops, std::vector<CornerTriangle>& out) {
  thread_local Triangulator triangulator;
  triangulator.take(loops);
  triangulator.run(out);
}

}  // namespace ryosen
