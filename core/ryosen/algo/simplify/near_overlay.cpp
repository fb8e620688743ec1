#include "ryosen/algo/simplify/near_overlay.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "ryosen/geometry/unit_vector.h"

namespace ryosen {

namespace {

constexpr double nowhere_near = std::numeric_limits<double>::infinity();
// A place so near to a line lies on it: cuts along the same side of two targets leave nothing between them.
constexpr double line_width = 1e-13;
constexpr std::size_t most_parts = 256, most_halvings = 64;

}  // namespace

double NearOverlay::bound(const TriangleCorners& triangle, std::span<const NearTarget> targets, double most) {
  bound_ = 0;
  Part whole;
  for (const glm::dvec3& corner : triangle) whole.add(corner);
  parts_.assign(1, whole);
  const glm::dvec3 normal = unit_or_zero(area_normal(triangle));
  const Box box = target_of(triangle, 0).box;
  for (const NearTarget& target : targets) {
    if (are_apart(box, target.box, most)) continue;
    const Halves halves = halves_before(target, normal);
    if (!is_apart(whole, halves) && !take_out(target, halves, most)) return nowhere_near;
  }
  return prove_rest(targets, most) ? bound_ : nowhere_near;
}

// The halves have nothing within where the target is seen from its edge.
NearOverlay::Halves NearOverlay::halves_before(const NearTarget& target, const glm::dvec3& normal) {
  const double area = glm::dot(area_normal(target.corners), normal);
  Halves halves;
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec3 side = target.corners[(k + 1) % 3] - target.corners[k];
    const glm::dvec3 inward = area > 0 ? glm::cross(normal, side) : glm::cross(side, normal);
    halves[k] = {area != 0 ? unit_or_zero(inward) : glm::dvec3(0.0), target.corners[k]};
  }
  return halves;
}

// These parts lie before no target, or before one that is not near enough: they are halved until each is near one.
bool NearOverlay::prove_rest(std::span<const NearTarget> targets, double most) {
  for (std::size_t halvings = 0; !parts_.empty();) {
    const Part part = parts_.back();
    parts_.pop_back();
    std::array<double, most_corners> least;
    least.fill(nowhere_near);
    double far = nowhere_near;
    const Box box = part.box();
    for (const NearTarget& target : targets) {
      if (are_apart(box, target.box, most)) continue;
      double farthest = 0;
      for (std::size_t i = 0; i < part.count; ++i) {
        const double corner = distance(part.corners[i], target);
        least[i] = std::min(least[i], corner);
        farthest = std::max(farthest, corner);
      }
      far = std::min(far, farthest);
      if (far <= bound_) break;
    }
    if (far <= most && far < nowhere_near) {
      bound_ = std::max(bound_, far);
      continue;
    }
    const bool is_far = std::any_of(least.begin(), least.begin() + static_cast<std::ptrdiff_t>(part.count),
                                    [&](double corner) { return corner > most; });
    if (is_far || ++halvings > most_halvings) return false;
    const auto [first, second] = part.halves();
    parts_.insert(parts_.end(), {first, second});
  }
  return true;
}

// Whether one side of a target tells that nothing of a part lies before it.
bool NearOverlay::is_apart(const Part& part, const Halves& halves) {
  return std::any_of(halves.begin(), halves.end(), [&](const Half& half) {
    for (std::size_t i = 0; i < part.count; ++i)
      if (glm::dot(half.inward, part.corners[i] - half.from) > line_width) return false;
    return true;
  });
}

bool NearOverlay::take_out(const NearTarget& target, const Halves& halves, double most) {
  rest_.clear();
  for (const Part& part : parts_) {
    if (is_apart(part, halves)) {
      rest_.push_back(part);
      continue;
    }
    Part within = part;
    const std::size_t before = rest_.size();
    for (const Half& half : halves) {
      Part inner, beyond;
      if (!cut(within, half, inner, beyond)) return false;
      if (beyond.count > 0) rest_.push_back(beyond);
      within = inner;
      if (within.count == 0) break;
    }
    const double far = within.count > 0 ? farthest_corner(within, target, most) : nowhere_near;
    if (far <= most && far < nowhere_near) {
      bound_ = std::max(bound_, far);
    } else {
      rest_.resize(before);  // for the others
      rest_.push_back(part);
    }
    if (rest_.size() > most_parts) return false;
  }
  std::swap(parts_, rest_);
  return true;
}

bool NearOverlay::cut(const Part& part, const Half& half, Part& within, Part& beyond) {
  std::array<double, most_corners> heights{};
  bool is_within = false, is_beyond = false;
  for (std::size_t i = 0; i < part.count; ++i) {
    heights[i] = glm::dot(half.inward, part.corners[i] - half.from);
    is_within |= heights[i] > line_width;
    is_beyond |= heights[i] < -line_width;
  }
  if (!is_within) {
    beyond = part;
    return true;
  }
  if (!is_beyond) {
    within = part;
    return true;
  }
  if (part.count + 2 > most_corners) return false;
  for (std::size_t i = 0; i < part.count; ++i) {
    const std::size_t next = (i + 1) % part.count;
    if (heights[i] >= -line_width) within.add(part.corners[i]);
    if (heights[i] <= line_width) beyond.add(part.corners[i]);
    const bool goes_in = heights[i] < -line_width && heights[next] > line_width,
               goes_out = heights[i] > line_width && heights[next] < -line_width;
    if (!goes_in && !goes_out) continue;
    const double along = heights[i] / (heights[i] - heights[next]);
    const glm::dvec3 place = part.corners[i] + along * (part.corners[next] - part.corners[i]);
    within.add(place);
    beyond.add(place);
  }
  return true;
}

double NearOverlay::farthest_corner(const Part& part, const NearTarget& target, double enough) {
  double far = target.bound;
  for (std::size_t i = 0; i < part.count && far <= enough; ++i) far = std::max(far, distance(part.corners[i], target));
  return far;
}

double NearOverlay::distance(const glm::dvec3& p, const NearTarget& target) {
  ++looks_;
  return distance_to_triangle(target, p) + target.bound;
}

}  // namespace ryosen
