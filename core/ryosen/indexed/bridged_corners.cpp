#include "ryosen/indexed/bridged_corners.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "ryosen/geometry/locate.h"
#include "ryosen/geometry/polygon_normal.h"
#include "ryosen/geometry/predicates.h"
#include "ryosen/geometry/triangulate.h"
#include "ryosen/mesh/bridges.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/face_polygon.h"

namespace ryosen {

namespace {

// Whether every bridge of the mesh face is also a side of the list (whose loops are known to be equal).
bool has_bridges_of(const Mesh& mesh, Face f, std::span<const std::uint32_t> list) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> sides;
  for (std::size_t i = 0; i < list.size(); ++i) sides.emplace_back(list[i], list[(i + 1) % list.size()]);
  std::sort(sides.begin(), sides.end());
  for (Halfedge h : halfedges_around(mesh, f)) {
    const std::pair side(point(mesh, mesh.from(h)).index, point(mesh, mesh.to(h)).index);
    if (is_bridge(mesh, h) && !std::binary_search(sides.begin(), sides.end(), side)) return false;
  }
  return true;
}

constexpr std::size_t most_corners_for_all_pairs = 2000;
// Budget of visibility tests (segments compared with a bridge) before falling back from all pairs to a triangulation.
constexpr std::size_t most_segments_tried = 20'000'000;

struct Bridge {
  std::uint32_t a, b;
  double length2;
};

// Joins the loops of a polygon with holes into one closed corner list, as in files: the loops, the outer one first, by
// bridges traversed in both directions: the shortest that cross nothing in the projection along the polygon's dominant
// axis or, if none is visible (crossing loops), the shortest of all. Corners are numbered consecutively over the loops;
// the list starts with corner 0 and keeps the sides of every loop in order. With more than 2000 corners, or when the
// budget of visibility tests runs out, only edges of a triangulation are candidates. O(n² log n) up to 2000 corners,
// O(n log n) beyond, plus the bounded visibility tests.
class Bridger {
 public:
  explicit Bridger(std::span<const std::span<const glm::dvec3>> loops) : loops_(loops) {
    for (const auto& loop : loops) {
      const auto begin = static_cast<std::uint32_t>(places_.size());
      for (std::uint32_t i = 0; i < loop.size(); ++i) {
        places_.push_back(loop[i]);
        next_.push_back(begin + (i + 1) % static_cast<std::uint32_t>(loop.size()));
        group_.push_back(static_cast<std::uint32_t>(&loop - loops.data()));
      }
    }
    look_along_normal();
    bridges_at_.resize(places_.size());
  }

  std::vector<std::uint32_t> walk() {
    choose(true, places_.size() <= most_corners_for_all_pairs);
    choose(true, false);
    choose(false, false);
    choose(false, true);
    for (std::uint32_t c = 0; c < bridges_at_.size(); ++c)
      std::sort(bridges_at_[c].begin(), bridges_at_[c].end(),
                [&](std::uint32_t s, std::uint32_t t) { return is_before(c, t, s); });  // clockwise
    std::vector<std::uint32_t> out;
    std::uint32_t corner = 0;
    do {
      emit_corner(corner, out);
      corner = next_[corner];
    } while (corner != 0);
    return out;
  }

 private:
  void look_along_normal() {
    glm::dvec3 sum(0.0);
    for (const auto& loop : loops_) sum += vector_area(loop);
    const int axis = view_axis(sum);
    const bool mirrored = sum[axis] < 0;
    for (const glm::dvec3& p : places_) {
      const glm::dvec2 seen = seen_along(p, axis);
      view_.push_back(mirrored ? glm::dvec2(-seen.x, seen.y) : seen);
    }
  }

  std::vector<Bridge> candidates(bool all_pairs) const {
    std::vector<Bridge> found;
    const auto add = [&](std::uint32_t a, std::uint32_t b) {
      if (group_[a] == group_[b]) return;
      const glm::dvec3 d = places_[b] - places_[a];
      found.push_back({std::min(a, b), std::max(a, b), glm::dot(d, d)});
    };
    if (all_pairs) {
      for (std::uint32_t a = 0; a < places_.size(); ++a)
        for (std::uint32_t b = a + 1; b < places_.size(); ++b) add(a, b);
    } else {
      std::vector<CornerTriangle> triangles;
      triangulate_loops(loops_, triangles);
      for (const CornerTriangle& t : triangles)
        for (int k = 0; k < 3; ++k) add(t[static_cast<std::size_t>(k)], t[static_cast<std::size_t>((k + 1) % 3)]);
    }
    std::sort(found.begin(), found.end(), [](const Bridge& s, const Bridge& t) {
      if (s.length2 != t.length2) return s.length2 < t.length2;
      return s.a != t.a ? s.a < t.a : s.b < t.b;
    });
    return found;
  }

  // Adds bridges, shortest first, until all loops are connected (Kruskal).
  void choose(bool only_visible, bool all_pairs) {
    std::vector<std::uint32_t> set(loops_.size());
    for (std::uint32_t i = 0; i < set.size(); ++i) set[i] = i;
    const auto root = [&](std::uint32_t i) {
      while (set[i] != i) i = set[i] = set[set[i]];
      return i;
    };
    for (const Bridge& b : chosen_) set[root(group_[b.a])] = root(group_[b.b]);
    if (chosen_.size() + 1 == loops_.size()) return;
    std::size_t segments = 0;
    for (const Bridge& b : candidates(all_pairs)) {
      const std::uint32_t s = root(group_[b.a]), t = root(group_[b.b]);
      if (s == t) continue;
      if (only_visible) {
        segments += places_.size();
        if (segments > most_segments_tried) return;
        if (!is_visible(b)) continue;
      }
      set[s] = t;
      chosen_.push_back(b);
      bridges_at_[b.a].push_back(b.b);
      bridges_at_[b.b].push_back(b.a);
      if (chosen_.size() + 1 == loops_.size()) return;
    }
  }

  bool is_visible(const Bridge& bridge) const {
    for (std::uint32_t c = 0; c < next_.size(); ++c)
      if (meets(bridge, c, next_[c])) return false;
    return std::none_of(chosen_.begin(), chosen_.end(), [&](const Bridge& b) { return meets(bridge, b.a, b.b); });
  }

  // Whether the bridge meets the segment c-d other than at a common end.
  bool meets(const Bridge& bridge, std::uint32_t c, std::uint32_t d) const {
    const glm::dvec2 &a = view_[bridge.a], &b = view_[bridge.b], &p = view_[c], &q = view_[d];
    const bool shares_c = c == bridge.a || c == bridge.b, shares_d = d == bridge.a || d == bridge.b;
    if (shares_c || shares_d) {
      // They overlap only when they leave the common end in the same direction.
      const glm::dvec2& shared = shares_c ? p : q;
      const glm::dvec2& other = shares_c ? q : p;
      const glm::dvec2& far = shared == a ? b : a;
      return orient2d(shared, far, other) == 0 && glm::dot(far - shared, other - shared) > 0;
    }
    const int pa = orient2d(p, q, a), pb = orient2d(p, q, b), ac = orient2d(a, b, p), ad = orient2d(a, b, q);
    if (pa * pb > 0 || ac * ad > 0) return false;
    if (pa != 0 || pb != 0 || ac != 0 || ad != 0) return true;
    // All four points collinear.
    const auto overlap = [](double s, double t, double u, double v) {
      return std::max(std::min(s, t), std::min(u, v)) <= std::min(std::max(s, t), std::max(u, v));
    };
    return overlap(a.x, b.x, p.x, q.x) && overlap(a.y, b.y, p.y, q.y);
  }

  // Counter-clockwise angular order of c -> s and c -> t, starting at the side that leaves c.
  bool is_before(std::uint32_t c, std::uint32_t s, std::uint32_t t) const {
    const glm::dvec2 &o = view_[c], &n = view_[next_[c]];
    const auto half = [&](std::uint32_t x) {
      const int side = orient2d(o, n, view_[x]);
      return side > 0 || (side == 0 && glm::dot(n - o, view_[x] - o) > 0) ? 0 : 1;
    };
    if (half(s) != half(t)) return half(s) < half(t);
    return orient2d(o, view_[s], view_[t]) > 0;
  }

  // Walks over a bridge and around the loop there, ending at that end of the bridge. Recursion depth: loops in a chain.
  void cross(std::uint32_t here, std::uint32_t there, std::vector<std::uint32_t>& out) {
    const std::vector<std::uint32_t>& at = bridges_at_[there];
    const auto arrival = static_cast<std::size_t>(std::find(at.begin(), at.end(), here) - at.begin());
    out.push_back(there);
    for (std::size_t i = arrival + 1; i < at.size(); ++i) cross_and_return(there, at[i], out);
    for (std::uint32_t c = next_[there]; c != there; c = next_[c]) emit_corner(c, out);
    out.push_back(there);
    for (std::size_t i = 0; i < arrival; ++i) cross_and_return(there, at[i], out);
  }

  void cross_and_return(std::uint32_t here, std::uint32_t there, std::vector<std::uint32_t>& out) {
    cross(here, there, out);
    out.push_back(here);
  }

  void emit_corner(std::uint32_t c, std::vector<std::uint32_t>& out) {
    out.push_back(c);
    for (std::uint32_t there : bridges_at_[c]) cross_and_return(c, there, out);
  }

  std::span<const std::span<const glm::dvec3>> loops_;
  std::vector<glm::dvec3> places_;
  std::vector<glm::dvec2> view_;
  std::vector<std::uint32_t> next_, group_;
  std::vector<Bridge> chosen_;
  std::vector<std::vector<std::uint32_t>> bridges_at_;
};

}  // namespace

bool visits_a_corner_twice(const Mesh& mesh, Face f) {
  if (mesh.has_rings(f)) return true;
  std::uint32_t corners = 0;
  for (Halfedge h : halfedges_around(mesh, f)) {
    ++corners;
    if (is_bridge(mesh, h)) return true;
    if (corners == 3 && mesh.next(h) == mesh.halfedge(f)) return false;
  }
  return false;
}

std::optional<std::vector<std::pair<Halfedge, std::size_t>>> corners_as_in_file(const Mesh& mesh, Face f,
                                                                                std::span<const std::uint32_t> list) {
  CornerLoops now, then;
  std::vector<std::pair<std::uint32_t, Halfedge>> corner_of;  // by point
  for_each_loop(mesh, f, [&](Halfedge start) {
    std::vector<std::uint32_t> points;
    for (Halfedge h : loop(mesh, start)) {
      points.push_back(point(mesh, mesh.from(h)).index);
      if (!is_bridge(mesh, h)) corner_of.emplace_back(points.back(), h);
    }
    now.add(points);
  });
  then.add(list);
  const auto parts_now = take_out_bridges(now), parts_then = take_out_bridges(then);
  if (!parts_now || !parts_then || normal_form(now, *parts_now) != normal_form(then, *parts_then)) return std::nullopt;
  if (!has_bridges_of(mesh, f, list)) return std::nullopt;
  std::sort(corner_of.begin(), corner_of.end());
  std::vector<std::pair<std::uint32_t, std::size_t>> place_of;  // by point, its index in the list
  for (const auto& part : *parts_then)
    for (std::uint32_t place : part) place_of.emplace_back(list[place], place);
  std::sort(place_of.begin(), place_of.end());
  std::vector<std::pair<Halfedge, std::size_t>> corners;
  for (std::uint32_t p : list) {
    const auto corner = std::lower_bound(corner_of.begin(), corner_of.end(), std::pair(p, Halfedge(0)));
    const auto place = std::lower_bound(place_of.begin(), place_of.end(), std::pair(p, std::size_t{0}));
    corners.emplace_back(corner->second, place->second);
  }
  return corners;
}

std::vector<Halfedge> corners_with_bridges(const Mesh& mesh, Face f) {
  const FacePolygon polygon(mesh, f);
  if (!mesh.has_rings(f)) return polygon.corners();
  std::vector<Halfedge> corners;
  for (std::uint32_t corner : Bridger(polygon.loops()).walk()) corners.push_back(polygon.corners()[corner]);
  return corners;
}

}  // namespace ryosen
