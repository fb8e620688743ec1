#include "ryosen/algo/repair/stitch.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "ryosen/algo/repair/detach_nonmanifold.h"
#include "ryosen/algo/repair/near_points.h"
#include "ryosen/algo/repair/side_effects.h"
#include "ryosen/algo/repair/sides_apart.h"
#include "ryosen/algo/repair/sound_changes.h"
#include "ryosen/algo/repair/weld_points.h"
#include "ryosen/analysis/neighbourhood.h"
#include "ryosen/base/count_text.h"
#include "ryosen/base/interruption.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/geometry/place_keys.h"
#include "ryosen/geometry/trees/bvh.h"
#include "ryosen/geometry/trees/primitive.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/ops/rules/point_in_edge.h"
#include "ryosen/ops/split_edge.h"

namespace ryosen {

namespace {

struct TJunction {
  Halfedge side;  // with a face and none beyond
  Vertex point;   // which lies on the side, between its ends
  double share;   // of the way along the side, 0 to 1
};

// How many sides that pass a point count: those along sides that end there, by their number, and others.
constexpr std::uint32_t most_along = 8, most_along_each = 2, most_others = 256;

// More than the rounding of a distance from a line, as a share of the largest coordinate.
constexpr double rounding = 1e-12;

struct Segment {
  glm::dvec3 a, b;
  double reach;  // how far from it places count

  Segment(const Mesh& m, Halfedge side, double distance) : a(m.position(m.from(side))), b(m.position(m.to(side))) {
    reach = distance + rounding * (largest_magnitude(a) + largest_magnitude(b));
  }

  // Visits the points within the reach, and few others.
  Frustum beam() const {
    const Box box = box_of(std::array{a, b});
    Frustum beam = frustum_of_box({box.lowest - reach, box.highest + reach});
    const glm::dvec3 way = b - a;
    const double length = glm::length(way);
    if (!(length > 1e-75 && length < 1e75)) return beam;
    const glm::dvec3 along = way / length;
    const int axis = dominant_axis();
    glm::dvec3 other(0);
    other[(axis + 1) % 3] = 1;
    const glm::dvec3 beside = glm::normalize(glm::cross(along, other)), above = glm::cross(along, beside);
    for (const glm::dvec3& normal : {beside, -beside, above, -above})
      beam.add(glm::dvec4(normal, 2 * reach - glm::dot(normal, a)));
    return beam;
  }

  int dominant_axis() const {
    const glm::dvec3 size = glm::abs(b - a);
    return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  }

  bool holds(const glm::dvec3& p) const {
    if (!are_collinear(a, b, p)) return false;
    const int axis = dominant_axis();
    return (a[axis] < p[axis]) != (b[axis] < p[axis]) && p[axis] != a[axis] && p[axis] != b[axis];
  }

  double share(const glm::dvec3& p) const {
    const int axis = dominant_axis();
    return std::clamp((p[axis] - a[axis]) / (b[axis] - a[axis]), 0.0, 1.0);
  }
};

// The same number for places in one direction from p or the opposite one, but for rounding, and rarely for others.
double number_of_direction(const glm::dvec3& p, const glm::dvec3& q) {
  const glm::dvec3 way = glm::abs(q / 2.0 - p / 2.0);
  const double most = std::max({way.x, way.y, way.z});
  return most > 0 ? glm::dot(way / most, glm::dvec3(0.613, 0.257, 0.911)) : 0;
}

class Search {
 public:
  Search(const Mesh& m, const NearPoints& near, double distance)
      : m_(m), near_(near), distance_(distance), sides_(lone_sides(m, near.first)) {}

  std::vector<TJunction> run() {
    collect_points();
    for (const Halfedge side : sides_) {
      stop_if_interrupted();
      if (!is_flat(m_, m_.face(side))) ask(side);
    }
    return chosen();
  }

 private:
  struct Found {
    std::uint32_t side;  // a halfedge
    Vertex place;
    bool is_beside;  // not exactly on it
    Vertex point;
    std::uint32_t number;  // in points_

    friend auto operator<=>(const Found&, const Found&) = default;
  };

  // The lowest of several points at one place.
  void collect_points() {
    for (const Halfedge side : sides_)
      for (const Vertex v : {m_.from(side), m_.to(side)}) points_.push_back(point(m_, v));
    const auto key = [&](Vertex v) {
      const glm::dvec3& p = m_.position(v);
      return std::tuple(p.x, p.y, p.z);
    };
    std::sort(points_.begin(), points_.end(),
              [&](Vertex v, Vertex w) { return std::tuple(key(v), v) < std::tuple(key(w), w); });
    points_.erase(std::unique(points_.begin(), points_.end(),
                              [&](Vertex v, Vertex w) { return m_.position(v) == m_.position(w); }),
                  points_.end());
    std::vector<Primitive> primitives;
    for (const Vertex v : points_) primitives.push_back(Primitive::point(v.index));
    tree_.build(m_.positions(), std::move(primitives));
    along_.assign(points_.size(), 0);
    others_.assign(points_.size(), 0);
    collect_ends();
  }

  std::uint32_t number_of(const glm::dvec3& place) const {
    const auto at = std::lower_bound(points_.begin(), points_.end(), place,
                                     [&](Vertex v, const glm::dvec3& p) { return is_before(m_.position(v), p); });
    return static_cast<std::uint32_t>(at - points_.begin());
  }

  void collect_ends() {
    ends_.resize(points_.size());
    for (const Halfedge side : sides_) {
      const glm::dvec3 &a = m_.position(m_.from(side)), &b = m_.position(m_.to(side));
      ends_[number_of(a)].emplace_back(number_of_direction(a, b), m_.to(side));
      ends_[number_of(b)].emplace_back(number_of_direction(a, b), m_.from(side));
    }
    for (auto& ends : ends_) std::sort(ends.begin(), ends.end());
  }

  // Whether a side that ends at the point may run along this one for a while: else there is nothing to join.
  bool has_side_along(std::uint32_t i, const Segment& segment) const {
    const glm::dvec3& p = m_.position(points_[i]);
    const auto& ends = ends_[i];
    if (distance_ == 0) {
      constexpr double tolerance = 1e-9;
      const double number = number_of_direction(segment.a, segment.b);
      auto end = std::lower_bound(ends.begin(), ends.end(), std::pair(number - tolerance, Vertex(0)));
      for (; end != ends.end() && end->first <= number + tolerance; ++end)
        if (are_collinear(segment.a, segment.b, m_.position(end->second))) return true;
      return false;
    }
    const auto is_near = [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& q) {
      const std::array places{a, b};
      return nearest_place(places, Primitive::segment(0, 1, 0), q).distance <= segment.reach;
    };
    return std::any_of(ends.begin(), ends.end(), [&](const auto& end) {
      const glm::dvec3& q = m_.position(end.second);
      return is_near(segment.a, segment.b, q) || is_near(p, q, segment.a) || is_near(p, q, segment.b);
    });
  }

  bool is_crowded(std::uint32_t i) const {
    return along_[i] > most_along + most_along_each * ends_[i].size() || others_[i] > most_others;
  }

  void ask(Halfedge side) {
    const Segment segment(m_, side, distance_);
    const Vertex from = place_of(m_.from(side)), to = place_of(m_.to(side));
    std::vector<std::uint32_t> crowded;
    tree_.visit_frustum(m_.positions(), segment.beam(), [&](std::uint32_t i) {
      const Vertex place = place_of(points_[i]);
      if (place == from || place == to) return;
      const glm::dvec3& p = m_.position(points_[i]);
      const double distance =
          nearest_place(m_.positions(), Primitive::segment(m_.from(side).index, m_.to(side).index, 0), p).distance;
      if (!(distance <= segment.reach)) return;
      const bool is_along = has_side_along(i, segment);
      ++(is_along ? along_ : others_)[i];
      if (is_crowded(i)) crowded.push_back(i);
      if (!is_along) return;
      const bool is_on = segment.holds(p);
      const bool is_near = distance_ > 0 && distance <= distance_ && glm::distance(p, segment.a) > distance_ &&
                           glm::distance(p, segment.b) > distance_;
      if (is_on || is_near) found_.push_back({side.index, place, !is_on, points_[i], i});
    });
    for (const std::uint32_t i : crowded) tree_.erase(i);
  }

  std::vector<TJunction> chosen() {
    std::vector<std::uint32_t> crowded;  // sides
    for (const Found& f : found_)
      if (is_crowded(f.number)) crowded.push_back(f.side);
    sort_unique(crowded);
    std::erase_if(found_, [&](const Found& f) {
      return is_crowded(f.number) || std::binary_search(crowded.begin(), crowded.end(), f.side);
    });
    std::sort(found_.begin(), found_.end());
    found_.erase(std::unique(found_.begin(), found_.end(),
                             [](const Found& f, const Found& g) { return f.side == g.side && f.place == g.place; }),
                 found_.end());
    std::vector<TJunction> junctions;
    for (const Found& f : found_) {
      const Halfedge side(f.side);
      junctions.push_back({side, f.point, Segment(m_, side, 0).share(m_.position(f.point))});
    }
    std::stable_sort(junctions.begin(), junctions.end(), [&](const TJunction& j, const TJunction& k) {
      return j.side != k.side ? j.side < k.side : is_nearer_to_end(j, k);
    });
    return junctions;
  }

  bool is_nearer_to_end(const TJunction& j, const TJunction& k) const {
    const Segment segment(m_, j.side, 0);
    const int axis = segment.dominant_axis();
    const double x = m_.position(j.point)[axis], y = m_.position(k.point)[axis];
    return segment.a[axis] < segment.b[axis] ? x > y : x < y;
  }

  Vertex place_of(Vertex v) const { return near_.first[v.index]; }

  const Mesh& m_;
  const NearPoints& near_;
  double distance_;
  std::vector<Halfedge> sides_;
  std::vector<Vertex> points_;  // at their ends, at different places
  Bvh tree_;                    // of these
  // By number of a point: the other ends of the lone sides there, by direction; sides that near, along such ones or
  // not.
  std::vector<std::vector<std::pair<double, Vertex>>> ends_;
  std::vector<std::uint32_t> along_, others_;
  std::vector<Found> found_;
};

// The points at the ends of lone sides (lone_sides) that lie on other lone sides: exactly, or within the distance and
// farther than that from both ends. Of several points near each other on one side there is one. By side, those nearest
// to its end first. Sides of faces without area have none. Only sides count along which a side that ends at the point
// may run. The point and these sides are left out where there are far more of them than sides that end there, so that
// they lie on each other, or where hundreds of other sides pass there. `near` are the points that count as one. O(n log
// n), plus the places that lie between the sides of a slab around a side.
std::vector<TJunction> find_t_junctions(const Mesh& mesh, const NearPoints& near, double distance) {
  return Search(mesh, near, distance).run();
}

// The junctions of a mesh put in on a copy.
class Stitching {
 public:
  Stitching(const Mesh& before, Descent descent_before, const NearPoints& near, const Reach& reach,
            const std::vector<TJunction>& junctions)
      : mesh(before), descent(std::move(descent_before)), reach_(reach), is_concerned_(before.vertex_slots(), false) {
    Edit edit(mesh, nullptr, &descent);
    take_bow_ties_apart(edit, junctions);
    mark_places(near, junctions);
    for (const TJunction& junction : junctions) put_in(edit, junction);
    edit.commit();
  }

  // Returns for each junction whether one of its parts was joined.
  std::vector<bool> weld(Progress& progress) {
    Edit edit(mesh, nullptr, &descent);
    std::vector<Edge> joined = weld_near_points(edit, {reach_.distance, reach_.used, &is_concerned_}, progress);
    edit.commit();
    sort_unique(joined);
    std::vector<bool> is_joined;
    for (const auto& parts : parts_)
      is_joined.push_back(std::any_of(parts.begin(), parts.end(), [&](Edge e) {
        return e && std::binary_search(joined.begin(), joined.end(), e);
      }));
    return is_joined;
  }

  Mesh mesh;
  Descent descent;

 private:
  // Gives each fan at a junction a point of its own, since only points of one fan are welded.
  static void take_bow_ties_apart(Edit& edit, const std::vector<TJunction>& junctions) {
    std::vector<Vertex> bow_ties;
    for (const TJunction& junction : junctions) bow_ties.push_back(point(edit.mesh(), junction.point));
    sort_unique(bow_ties);
    Neighbourhood around(edit.mesh());
    std::erase_if(bow_ties, [&](Vertex p) { return around.star(p).has_nonmanifold_edge; });
    detach_points(edit, std::move(bow_ties), {});
  }

  // All points at the places of the junctions and of the ends of their sides.
  void mark_places(const NearPoints& near, const std::vector<TJunction>& junctions) {
    std::vector<bool> is_place(mesh.vertex_slots(), false);
    for (const TJunction& junction : junctions)
      for (const Vertex v : {junction.point, mesh.from(junction.side), mesh.to(junction.side)})
        is_place[near.first[v.index].index] = true;
    for (std::uint32_t i = 0; i < is_concerned_.size(); ++i)
      is_concerned_[i] = near.first[i] && is_place[near.first[i].index];
  }

  // Points of one side come from its end to its start, so the side is always the part at the start.
  void put_in(Edit& edit, const TJunction& junction) {
    if (parts_.empty() || junction.side != side_) {
      end_of_side_ = 1;
      last_ = no_index;
    }
    side_ = junction.side;
    const SplitEdge op{side_, end_of_side_ > 0 ? junction.share / end_of_side_ : 0, mesh.position(junction.point)};
    parts_.emplace_back();
    if (reach_.distance > 0 && !op.warnings(mesh).empty()) return;
    OpEffect effect;
    put_point_into(edit, side_, op.along, *op.place, CutTriangles::yes, effect);
    is_concerned_.resize(mesh.vertex_slots(), true);
    Edge behind;
    for (const Element& made : effect.created)
      if (made.kind == Element::Kind::edge && mesh.is_boundary(made.edge())) behind = made.edge();
    parts_.back() = {edge(side_), behind};
    if (last_ != no_index) parts_[last_][0] = behind;
    last_ = static_cast<std::uint32_t>(parts_.size() - 1);
    end_of_side_ = junction.share;
  }

  Reach reach_;
  std::vector<bool> is_concerned_;  // by vertex: what may be welded
  Halfedge side_;
  double end_of_side_ = 1;                  // the share of the original one at which it ends now
  std::uint32_t last_ = no_index;           // the junction at which it ends
  std::vector<std::array<Edge, 2>> parts_;  // by junction; none: it was not put in
};

struct Stitched {
  Mesh mesh;
  Descent descent;
  std::size_t points = 0;
};

// Puts in what can be joined; nothing where there is nothing.
std::optional<Stitched> stitch_once(const Mesh& mesh, const Descent& descent, const Reach& reach, Progress& progress) {
  constexpr int patient = 3, most_tries = 8;
  const NearPoints near = find_near_points(mesh, reach);
  std::vector<TJunction> junctions = find_t_junctions(mesh, near, reach.distance);
  for (int tries = 0; tries < most_tries && !junctions.empty() && progress.go_on(); ++tries) {
    Stitching stitching(mesh, descent, near, reach, junctions);
    const std::vector<bool> is_joined = stitching.weld(progress);
    if (progress.is_cancelled()) return std::nullopt;
    std::vector<Halfedge> in_vain;
    std::vector<TJunction> rest;
    for (std::size_t i = 0; i < junctions.size(); ++i)
      is_joined[i] ? rest.push_back(junctions[i]) : in_vain.push_back(junctions[i].side);
    if (in_vain.empty()) return Stitched{std::move(stitching.mesh), std::move(stitching.descent), junctions.size()};
    if (tries >= patient)  // then all at their sides, so that this ends soon
      std::erase_if(rest,
                    [&](const TJunction& j) { return std::binary_search(in_vain.begin(), in_vain.end(), j.side); });
    junctions = std::move(rest);
  }
  return std::nullopt;
}

}  // namespace

AlgorithmResult stitch(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  const Reach reach{input.values.length("distance"), input.used_elsewhere};
  AlgorithmResult result;
  std::optional<Mesh> stitched;
  Descent descent = edit.new_descent();
  while (auto more = stitch_once(stitched ? *stitched : edit.mesh(), descent, reach, progress)) {
    result.changed += more->points;
    stitched = std::move(more->mesh);
    descent = std::move(more->descent);
  }
  if (progress.is_cancelled()) return {};
  result.text = count_text(result.changed, "One vertex was put into the edge it lies on.",
                           "# vertices were put into the edges they lie on.",
                           "稜線の上にある頂点を # 個、その稜線に入れて縫合しました。");
  if (!stitched) return result;
  if (reach.distance > 0 && progress.go_on()) add_new_crossings(edit.mesh(), *stitched, result);
  edit.replace(std::move(*stitched).columns(), descent);
  return result;
}

}  // namespace ryosen
