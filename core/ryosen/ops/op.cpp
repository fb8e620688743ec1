#include "ryosen/ops/op.h"

#include <algorithm>
#include <cmath>

namespace ryosen {

double OpTarget::snapped_along() const {
  constexpr double near_middle = 0.08;
  const double parts = is_free ? 1000 : 10;
  if (!is_free && std::abs(along - 0.5) < near_middle) return 0.5;
  return std::clamp(std::round(along * parts), 1.0, parts - 1) / parts;
}

}  // namespace ryosen
