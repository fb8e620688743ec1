#include "ryosen/algo/crossings/faces_at_hubs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "ryosen/geometry/ray.h"

namespace ryosen {

namespace directions {

namespace {

// More than the rounding of a plane through two directions and of its distance from a third one.
constexpr double plane_rounding = 1e-13;

// What lies between two directions, and beside that by so much.
void add_sector(Frustum& cone, const glm::dvec3& a, const glm::dvec3& b, double beside) {
  const glm::dvec3 normal = glm::cross(a, b);
  for (const glm::dvec3& inwards : {normal, -normal, glm::cross(normal, a), glm::cross(b, normal)})
    cone.add(glm::dvec4(inwards, beside + plane_rounding));
}

// The directions in which a triangle lies; perhaps some more, all of them where that cannot be told, and where a corner
// of another number than that of the point lies at its place.
Frustum cone_of(const NumberedTriangle& triangle, std::uint32_t point, const glm::dvec3& place) {
  Frustum cone;
  std::array<glm::dvec3, 3> d;
  for (std::size_t i = 0; i < 3; ++i) d[i] = direction(place, triangle.places[i]);
  if (!is_finite(d[0]) || !is_finite(d[1]) || !is_finite(d[2])) return cone;
  for (std::size_t i = 0; i < 3; ++i)
    if (d[i] == glm::dvec3(0)) {
      if (triangle.numbers[i] != point) return cone;
      const glm::dvec3 &a = d[(i + 1) % 3], &b = d[(i + 2) % 3];
      if (is_somewhere(a) && is_somewhere(b)) add_sector(cone, a, b, 0);
      return cone;
    }
  constexpr double flat = 1e-12;
  const double det = glm::dot(glm::cross(d[0], d[1]), d[2]);
  if (std::abs(det) > flat) {
    for (std::size_t i = 0; i < 3; ++i)
      cone.add(glm::dvec4((det > 0 ? 1.0 : -1.0) * glm::cross(d[i], d[(i + 1) % 3]), plane_rounding));
    return cone;
  }
  // Seen from within its plane: between two corners, the third one among them, unless the place is inside.
  std::size_t widest = 3;
  double width = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 &a = d[i], &b = d[(i + 1) % 3], &c = d[(i + 2) % 3], normal = glm::cross(a, b);
    const bool holds_third = glm::dot(glm::cross(normal, a), c) >= -flat && glm::dot(glm::cross(b, normal), c) >= -flat;
    if (!holds_third || !(glm::dot(normal, normal) > width)) continue;
    width = glm::dot(normal, normal);
    widest = i;
  }
  if (widest < 3) add_sector(cone, d[widest], d[(widest + 1) % 3], flat);
  return cone;
}

// An edge between two places, and what is seen along it: the directions across it in which others lie.
struct Spine {
  glm::dvec3 a, b;
};

// Along a spine. Lengths are shares of the way to a place, angles in radians. Pages keep a distance from the line
// through the spine where that has left it; so a corner on the line that is clearly beyond an end does not tell where a
// triangle lies: what it has outside of the wedge of its other corners is nearer to the line than any page is there.
constexpr double rounding = 1e-14;         // of what is taken away along the line, generously
constexpr double on_line = 1e-13;          // most across of what is on the line
constexpr double steep = 1e-3;             // least across of a page, from both ends
constexpr double steep_beyond = 1e-2;      // the same of corners, from one on the line
constexpr double beyond = 4e-3;            // least from the nearer end, of the way from the other one
constexpr double beside_of_beyond = 1e-6;  // how far such a corner leads out of the wedge
constexpr double open_beyond = 0.1;        // least sum of the unit vectors of the wedge's sides

glm::dvec3 across(const glm::dvec3& along, const glm::dvec3& way) {
  return way - glm::dot(way, along) / glm::dot(along, along) * along;
}

// The end that a place on the line is clearly beyond.
std::optional<std::size_t> end_before(const Spine& spine, const glm::dvec3& place) {
  const glm::dvec3 from_a = place - spine.a, from_b = place - spine.b;
  const double a = largest_magnitude(from_a), b = largest_magnitude(from_b);
  if (!(glm::dot(from_a, from_b) > 0 && std::min(a, b) >= beyond * std::max(a, b))) return {};
  return a < b ? 0 : 1;
}

// The directions between those of unit length; of all where they lie all around, or nearly so.
Frustum wedge_of(std::span<const glm::dvec3> seen, const glm::dvec3& along, double slack, double open) {
  for (const glm::dvec3& a : seen)
    for (const glm::dvec3& b : seen) {
      const glm::dvec3 left = glm::cross(along, a), right = glm::cross(b, along), middle = a + b;
      const auto is_between = [&](const glm::dvec3& d) {
        return glm::dot(left, d) >= -slack && glm::dot(right, d) >= -slack && glm::dot(middle, d) >= -slack;
      };
      if (glm::length(middle) < open || !std::all_of(seen.begin(), seen.end(), is_between)) continue;
      Frustum wedge;
      for (const glm::dvec3& inwards : {left, right, middle}) wedge.add(glm::dvec4(inwards, 4 * slack));
      return wedge;
    }
  return {};
}

// Where a triangle at that edge is seen, by its third corner, within rounding. The largest coordinate of a direction is
// 1; everywhere where it cannot be told.
Box page_of(const Spine& spine, const glm::dvec3& third) {
  const Box everywhere{glm::dvec3(-2), glm::dvec3(2)};
  const glm::dvec3 along = direction(spine.a, spine.b), way = direction(spine.a, third),
                   back = direction(spine.b, third);
  if (!is_somewhere(along) || !is_somewhere(way) || !is_somewhere(back)) return everywhere;
  const glm::dvec3 beside = across(along, way);
  const double size = largest_magnitude(beside);
  if (!(size >= steep && largest_magnitude(across(along, back)) >= steep)) return everywhere;
  return {beside / size - rounding / size, beside / size + rounding / size};
}

// Where those pages are seen that a triangle meets elsewhere than at the ends, where it may have corners of these
// numbers; perhaps some more.
Frustum wedge_of(const NumberedTriangle& triangle, std::span<const std::uint32_t> numbers, const Spine& spine) {
  const glm::dvec3 along = direction(spine.a, spine.b);
  if (!is_somewhere(along)) return {};
  double slack = 1e-12, open = 1e-6;
  std::vector<glm::dvec3> seen, beside, on_the_line;
  std::array<bool, 2> ends{};  // that it touches, or is beyond, on the line
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t number = triangle.numbers[i];
    const glm::dvec3& place = triangle.places[i];
    const bool is_a = number == numbers[0] && place == spine.a, is_b = number == numbers[1] && place == spine.b;
    if (is_a || is_b) {
      ends[is_a ? 0 : 1] = true;
      continue;
    }
    const glm::dvec3 way = direction(spine.a, place);
    if (!is_somewhere(way)) return {};
    const glm::dvec3 off = across(along, way);
    if (const double size = largest_magnitude(off); size > 1e-8) {
      seen.push_back(glm::normalize(off));
      beside.push_back(place);
      slack = std::max(slack, rounding / size);
    } else if (const std::optional<std::size_t> end = end_before(spine, place); size <= on_line && end) {
      on_the_line.push_back(place);
      ends[*end] = true;
    } else {
      return {};
    }
  }
  for (const glm::dvec3& from : on_the_line)
    for (const glm::dvec3& to : beside)
      if (!(largest_magnitude(across(along, direction(from, to))) >= steep_beyond)) return {};
  if (!on_the_line.empty()) {
    if (ends[0] && ends[1]) return {};  // it lies along the spine
    slack = std::max(slack, beside_of_beyond);
    open = open_beyond;
  }
  return wedge_of(seen, glm::normalize(along), slack, open);
}

}  // namespace

glm::dvec3 direction(const glm::dvec3& from, const glm::dvec3& to) {
  const glm::dvec3 way = to - from;
  const double size = largest_magnitude(way);
  return size > 0 ? way / size : glm::dvec3(0);
}

Frustum slab_of(const TriangleCorners& t) {
  Frustum slab = frustum_of_box(box_of(t));
  const std::array<glm::dvec3, 3> sides{t[1] - t[0], t[2] - t[1], t[0] - t[2]};
  const glm::dvec3 normal = glm::cross(sides[0], sides[1]);
  const double longest = std::max({glm::length(sides[0]), glm::length(sides[1]), glm::length(sides[2])});
  if (!(longest > 1e-75 && longest < 1e75)) return slab;
  const auto add = [&](const glm::dvec3& inwards, const glm::dvec3& through, double size) {
    const double slack = plane_rounding * size * (glm::length(through) + longest);
    slab.add(glm::dvec4(inwards, slack - glm::dot(inwards, through)));
  };
  for (const double side : {1.0, -1.0}) add(side * normal, t[0], longest * longest);
  for (std::size_t i = 0; i < 3; ++i) add(glm::cross(normal, sides[i]), t[i], longest * longest * longest);
  return slab;
}

}  // namespace directions

FacesAtHubs::FacesAtHubs(std::span<const glm::dvec3> ends) : places_(ends.begin(), ends.end()) {}

FacesAtHubs::Slot FacesAtHubs::add(Face f, const TriangleCorners& corners) {
  auto slot = static_cast<Slot>(faces_.size());
  if (free_slots_.empty()) {
    faces_.emplace_back();
  } else {
    slot = free_slots_.back();
    free_slots_.pop_back();
  }
  faces_[slot] = f;
  change(slot, corners);
  return slot;
}

void FacesAtHubs::change(Slot slot, const TriangleCorners& corners) {
  seen_.resize(2 * faces_.size());
  reach_.add(box_of(corners));
  if (places_.size() == 1) {
    for (std::uint32_t i : {0u, 1u}) seen_[2 * slot + i] = directions::direction(places_[0], corners[i + 1]);
  } else {
    const Box page = directions::page_of({places_[0], places_[1]}, corners[2]);
    seen_[2 * slot] = page.lowest;
    seen_[2 * slot + 1] = page.highest;
  }
  tree_.insert(seen_, slot, Primitive::segment(2 * slot, 2 * slot + 1, slot));
}

void FacesAtHubs::erase(Slot slot) {
  tree_.erase(slot);
  faces_[slot] = Face();
  free_slots_.push_back(slot);
}

Frustum FacesAtHubs::region_of(const NumberedTriangle& triangle, std::span<const std::uint32_t> numbers) const {
  return places_.size() == 1 ? directions::cone_of(triangle, numbers[0], places_[0])
                             : directions::wedge_of(triangle, numbers, {places_[0], places_[1]});
}

}  // namespace ryosen
