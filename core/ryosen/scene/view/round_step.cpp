#include "ryosen/scene/view/round_step.h"

#include <algorithm>
#include <cmath>

namespace ryosen {

double RoundStep::times(double count) const {
  // Negative powers of ten are no doubles: the quotient of two that are is rounded once.
  return power < 0 ? count * leading / std::pow(10.0, -power) : count * leading * std::pow(10.0, power);
}

double RoundStep::nearest_to(double value) const { return times(std::round(value / size())); }

RoundStep round_step(double length) {
  constexpr double tolerance = 1 + 1e-6;
  const double wide = length * tolerance;
  const double power = std::floor(std::log10(wide));
  const double leading = wide / std::pow(10.0, power);
  return {leading >= 5 ? 5 : leading >= 2 ? 2 : 1, static_cast<int>(power)};
}

double ground_extent(const glm::dvec3& size) { return std::max({size.x, size.z, 0.5 * size.y}); }

RoundStep ground_step(double extent) {
  constexpr double cells = 8;
  return round_step(extent / cells);
}

}  // namespace ryosen
