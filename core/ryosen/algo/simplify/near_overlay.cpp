#include "ryosen/algo/simplify/near_overlay.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "ryosen/geometry/closest.h"

namespace ryosen {

namespace {

constexpr double nowhere_near = std::numeric_limits<double>::infinity();
// What lies so near to a line lies on it: cuts along the same side of two targets leave nothing between them.
constexpr double line_width = 1e-13;
constexpr std::size_t most_parts = 256, most_halvings = 64;

}  // namespace

double NearOverlay::bound(const TriangleCorners& triangle, std::span<const NearTarget> targets, double most) {
  bound_ = 0;
  Part whole;
  for (const glm::dvec3& corner : triangle) whole.add(corner);
  parts_.assign(1, whole);
  glm::dvec3 normal = area_normal(triangle);
  if (const double length = glm::length(normal); length > 0) normal /= length;
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
    const double width = glm::length(inward);
    halves[k] = {width > 0 && area != 0 ? inward / width : glm::dvec3(0.0), target.corners[k]};
  }
  return halves;
}

// What lies before no target, or before one that is not near enough: parts are halved until each is near one.
bool NearOverlay::prove_rest(std::span<const NearTarget> targets, double most) {
  for (std::size_t halvings = 0; !parts_.empty();) {
    const Part part = parts_.back();
    parts_.pop_back();
    std::array<double, most_corners> least;
    least.fill(nowhere_near);
    double far = nowhere_near;
    Box box;
    for (std::size_t i = 0; i < part.count; ++i) box.add(part.corners[i]);
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
    halve(part);
  }
  return true;
}

void NearOverlay::halve(const Part& part) {
  const std::size_t n = part.count;
  const auto length = [&](std::size_t i) { return glm::length(part.corners[(i + 1) % n] - part.corners[i]); };
  std::size_t longest = 0;
  for (std::size_t i = 1; i < n; ++i)
    if (length(i) > length(longest)) longest = i;
  const glm::dvec3 middle = 0.5 * part.corners[longest] + 0.5 * part.corners[(longest + 1) % n];
  const std::size_t across = longest + 1 + n / 2;
  Part first, second;
  first.add(middle);
  second.add(middle);
  for (std::size_t i = longest + 1; i <= across; ++i) first.add(part.corners[i % n]);
  for (std::size_t i = across; i <= longest + n; ++i) second.add(part.corners[i % n]);
  parts_.push_back(first);
  parts_.push_back(second);
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
  const auto& [a, b, c] = target.corners;
  return glm::length(way_from_triangle(a, b, c, p)) + target.bound;
}

}  // namespace ryosen
