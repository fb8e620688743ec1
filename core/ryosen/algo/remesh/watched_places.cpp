#include "ryosen/algo/remesh/watched_places.h"

#include <algorithm>
#include <cmath>

namespace ryosen::remesh {

std::size_t WatchedPlaces::Hash::operator()(const Cell& c) const {
  std::uint64_t mixed = 0;
  for (const std::int64_t x : c) mixed = (mixed ^ static_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15u;
  return static_cast<std::size_t>(mixed ^ mixed >> 32u);
}

WatchedPlaces::Cell WatchedPlaces::cell_of(const glm::dvec3& place) const {
  Cell cell;
  for (int axis = 0; axis < 3; ++axis)
    cell[static_cast<std::size_t>(axis)] =
        static_cast<std::int64_t>(std::clamp(std::floor(place[axis] / cell_), -1e18, 1e18));
  return cell;
}

void WatchedPlaces::add(const Box& box) {
  constexpr double most_cells = 100000;
  const Cell low = cell_of(box.lowest), high = cell_of(box.highest);
  double count = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) count *= static_cast<double>(high[axis] - low[axis]) + 3;
  is_all_ |= !(count + static_cast<double>(cells_.size()) < most_cells);
  if (is_all_) return;
  for (std::int64_t x = low[0] - 1; x <= high[0] + 1; ++x)
    for (std::int64_t y = low[1] - 1; y <= high[1] + 1; ++y)
      for (std::int64_t z = low[2] - 1; z <= high[2] + 1; ++z) cells_.insert({x, y, z});
}

}  // namespace ryosen::remesh
