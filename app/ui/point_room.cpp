#include "app/ui/point_room.h"

#include <algorithm>
#include <cmath>

namespace ryosen {

double room_of_points(const Box& bounds, std::size_t count) {
  constexpr std::size_t few = 100;
  if (count < few || bounds.is_empty()) return 0;
  const glm::dvec3 size = bounds.highest - bounds.lowest;
  const double smallest = std::min({size.x, size.y, size.z}), largest = std::max({size.x, size.y, size.z});
  const double middle = size.x + size.y + size.z - smallest - largest, each = 1 / static_cast<double>(count);
  const double room = std::max(std::sqrt(largest * middle * each), largest * each);
  return room > 0 && std::isfinite(room) ? std::exp2(std::round(std::log2(room))) : 0;
}

}  // namespace ryosen
