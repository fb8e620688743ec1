#include "ryosen/analysis/overlap_view.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

namespace ryosen {

namespace {

// Box coordinates are clamped to this magnitude.
constexpr float far_away = 1e37F;
constexpr OverlapBox everywhere{{-far_away, -far_away, -far_away, -far_away}, {far_away, far_away, far_away, far_away}};

// A bounding box in doubles, inflated by rounding error bounds.
class WideBox {
 public:
  void add(const glm::dvec4& p, const glm::dvec4& rounding) {
    lowest_ = glm::min(lowest_, p - rounding);
    highest_ = glm::max(highest_, p + rounding);
    is_finite_ = is_finite_ && std::isfinite(p.x + p.y + p.z + p.w + rounding.x + rounding.w);
  }
  // `everywhere` on overflow.
  OverlapBox box() const {
    if (!is_finite_) return everywhere;
    OverlapBox box;
    for (int k = 0; k < 4; ++k) {
      box.lowest[static_cast<std::size_t>(k)] = rounded(lowest_[k]);
      box.highest[static_cast<std::size_t>(k)] = rounded(highest_[k]);
    }
    return box;
  }

 private:
  static float rounded(double x) { return static_cast<float>(std::clamp<double>(x, -far_away, far_away)); }

  bool is_finite_ = true;
  glm::dvec4 lowest_{std::numeric_limits<double>::infinity()}, highest_{-lowest_};
};

// A direction projected onto the unit octahedron (L1 sphere), with its L1 distance as fourth coordinate.
void add_direction(const glm::dvec3& d, WideBox& box) {
  constexpr double rounding = 1e-9;
  const double distance = std::abs(d.x) + std::abs(d.y) + std::abs(d.z);
  box.add({d / distance, distance}, {glm::dvec3(rounding), rounding * distance});
}

// The bends of a projected segment: where it crosses edges of the octahedron.
void add_bends(const glm::dvec3& d, const glm::dvec3& e, WideBox& box) {
  for (int k = 0; k < 3; ++k)
    if ((d[k] < 0.0 && e[k] > 0.0) || (d[k] > 0.0 && e[k] < 0.0)) {
      glm::dvec3 bend = d + (d[k] / (d[k] - e[k])) * (e - d);
      bend[k] = 0.0;
      add_direction(bend, box);
    }
}

// Adds the octahedron's vertices inside the projected triangle, both signs, at distance 0. One that almost lies on a
// side is skipped: a bend or a corner of the triangle is already there.
void add_tops(const std::array<glm::dvec3, 3>& d, WideBox& box) {
  constexpr double least_distance = 1e-13;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    // Orientation of the vertex relative to a side.
    const auto side = [&](const glm::dvec3& a, const glm::dvec3& b) {
      const double turn = a[i] * b[j] - a[j] * b[i], length = std::abs(a[i] - b[i]) + std::abs(a[j] - b[j]);
      return turn > least_distance * length ? 1 : turn < -least_distance * length ? -1 : 0;
    };
    if (std::abs(side(d[0], d[1]) + side(d[1], d[2]) + side(d[2], d[0])) < 3) continue;
    glm::dvec4 top(0.0);
    top[k] = 1.0;
    box.add(top, glm::dvec4(0.0));
    box.add(-top, glm::dvec4(0.0));
  }
}

}  // namespace

OverlapView OverlapView::from_tip(const glm::dvec3& tip, double scale, std::uint32_t number, const glm::dmat3& axes) {
  OverlapView view(tip, scale, axes);
  view.tip_ = number;
  return view;
}

OverlapBox OverlapView::box_of(const NumberedTriangle& t) const {
  return is_from_tip() ? box_of_directions(t) : box_of_places(t);
}

OverlapBox OverlapView::box_of_places(const NumberedTriangle& t) const {
  WideBox box;
  for (const glm::dvec3& place : t.places) {
    const glm::dvec3 p = (place * 0.5 - origin_ * 0.5) * (2.0 * scale_), seen = p * axes_;
    const double rounding = 1e-14 * (1.0 + std::abs(p.x) + std::abs(p.y) + std::abs(p.z));
    box.add({seen, seen.x + seen.y + seen.z}, glm::dvec4(rounding));
  }
  return box.box();
}

// The projection is ill-conditioned where a triangle passes close to the tip relative to its corners' distances. So a
// triangle gets the box `everywhere` unless its corners' directions are all well within one half-space.
OverlapBox OverlapView::box_of_directions(const NumberedTriangle& t) const {
  constexpr double smallest = 1e-290, least_cosine = 1e-2;
  std::array<glm::dvec3, 3> places, directions;
  std::size_t count = 0;
  glm::dvec3 sum(0.0);
  for (std::size_t k = 0; k < 3; ++k) {
    if (t.numbers[k] == tip_) continue;
    const glm::dvec3 d = t.places[k] * 0.5 - origin_ * 0.5, size = glm::abs(d);
    const double largest = std::max({size.x, size.y, size.z});
    if (!(largest > smallest && largest * scale_ > smallest)) return everywhere;
    places[count] = (d * scale_) * axes_;
    directions[count] = glm::normalize((d / largest) * axes_);
    sum += directions[count++];
  }
  WideBox box;
  for (std::size_t i = 0; i < count; ++i) {
    if (!(glm::dot(directions[i], sum) > least_cosine)) return everywhere;
    add_direction(places[i], box);
    for (std::size_t j = 0; j < i; ++j) add_bends(places[i], places[j], box);
  }
  if (count == 3) add_tops(directions, box);
  OverlapBox wide = box.box();
  if (count < 3) wide.lowest[3] = 0.0F;
  return wide;
}

glm::dmat3 axes_along(const glm::dvec3& axis) {
  const glm::dvec3 z = glm::normalize(axis / std::max({std::abs(axis.x), std::abs(axis.y), std::abs(axis.z)}));
  if (!(glm::dot(z, z) > 0.5)) return glm::dmat3(1.0);
  const glm::dvec3 size = glm::abs(z);
  const int least = size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2;
  glm::dvec3 aside(0.0);
  aside[least] = 1.0;
  const glm::dvec3 x = glm::normalize(glm::cross(aside, z));
  return {x, glm::cross(z, x), z};
}

void AlignedSum::add(const glm::dvec3& v) { sum_ += glm::dot(sum_, v) < 0.0 ? -v : v; }

}  // namespace ryosen
