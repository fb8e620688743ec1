#include "ryosen/algo/smooth/boundary_slide.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

namespace ryosen::smooth {

namespace {

constexpr std::size_t held = static_cast<std::size_t>(-1);

}  // namespace

BoundarySlide::BoundarySlide(std::vector<Point> points, const Places& places)
    : points_(std::move(points)), at_(points_.size()) {
  std::vector<std::size_t> slot_of(places.size(), held);
  for (std::size_t i = 0; i < points_.size(); ++i) slot_of[points_[i].point] = i;
  std::vector<std::uint8_t> is_known(points_.size());
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (!is_known[i]) follow(i, is_known, slot_of, places);
}

// The whole curve of a point.
void BoundarySlide::follow(std::size_t first, std::vector<std::uint8_t>& is_known,
                           const std::vector<std::size_t>& slot_of, const Places& places) {
  Curve& curve = curves_.emplace_back();
  std::size_t begin = first;
  while (slot_of[points_[begin].before] != held && !curve.is_loop) {
    begin = slot_of[points_[begin].before];
    curve.is_loop = begin == first;
  }
  const auto add = [&](std::uint32_t point) {
    const glm::dvec3& place = places[point];
    curve.lengths.push_back(curve.corners.empty() ? 0
                                                  : curve.lengths.back() + glm::distance(curve.corners.back(), place));
    curve.corners.push_back(place);
  };
  if (!curve.is_loop) add(points_[begin].before);
  for (std::size_t i = begin; i != held && !is_known[i]; i = slot_of[points_[i].after]) {
    is_known[i] = 1;
    curve.points.push_back(i);
    add(points_[i].point);
    at_[i] = curve.lengths.back();
  }
  add(points_[curve.points.back()].after);
}

glm::dvec3 BoundarySlide::place_at(const Curve& curve, double t) const {
  const double length = curve.lengths.back();
  if (curve.is_loop) t -= t >= length ? length : t < 0 ? -length : 0;
  const auto next = std::upper_bound(curve.lengths.begin() + 1, curve.lengths.end() - 1, t);
  const std::size_t i = static_cast<std::size_t>(next - curve.lengths.begin());
  const double before = curve.lengths[i - 1], way = curve.lengths[i] - before;
  const glm::dvec3 &a = curve.corners[i - 1], &b = curve.corners[i];
  return way > 0 ? a + std::clamp((t - before) / way, 0.0, 1.0) * (b - a) : a;
}

void BoundarySlide::step(double strength, Places& places) {
  for (const Curve& curve : curves_) {
    const std::size_t n = curve.points.size();
    const double length = curve.lengths.back();
    std::vector<double> moved(n);
    for (std::size_t k = 0; k < n; ++k) {
      const double here = at_[curve.points[k]];
      const double before = k > 0 ? at_[curve.points[k - 1]] : curve.is_loop ? at_[curve.points[n - 1]] - length : 0;
      const double after = k + 1 < n       ? at_[curve.points[k + 1]]
                           : curve.is_loop ? at_[curve.points[0]] + length
                                           : length;
      moved[k] = here + points_[curve.points[k]].share * strength * (0.5 * before + 0.5 * after - here);
    }
    for (std::size_t k = 0; k < n; ++k) {
      const std::size_t i = curve.points[k];
      if (moved[k] == at_[i]) continue;
      at_[i] = moved[k];
      places[points_[i].point] = place_at(curve, moved[k]);
    }
  }
}

}  // namespace ryosen::smooth
