#include "ryosen/hull/hull_links.h"

#include "ryosen/base/handle.h"

namespace ryosen::hull {

HullLinks::HullLinks(const ConvexHull& hull) : hull_(hull) {
  const auto count = static_cast<std::uint32_t>(hull.corners.size());
  next_.resize(count);
  facet_.resize(count);
  for (std::uint32_t f = 0; f < hull.facet_count(); ++f)
    for (std::uint32_t k = hull.facet_offsets[f]; k < hull.facet_offsets[f + 1]; ++k) {
      next_[k] = k + 1 < hull.facet_offsets[f + 1] ? k + 1 : hull.facet_offsets[f];
      facet_[k] = f;
    }
  // The sides by the point from which they run, so that the twin of one is among few.
  const std::size_t points = hull.vertices.empty() ? 0 : hull.vertices.back() + std::size_t{1};
  side_from_.assign(points, no_index);
  std::vector<std::uint32_t> another(count), before(count);  // that runs from the same point; in the same facet
  for (std::uint32_t k = count; k-- > 0;) {
    another[k] = side_from_[hull.corners[k]];
    side_from_[hull.corners[k]] = k;
    before[next_[k]] = k;
  }
  twin_.assign(count, no_index);
  std::vector<std::uint32_t> side_to(points, no_index);  // from the point that is looked at
  for (const std::uint32_t p : hull.vertices) {
    for (std::uint32_t k = side_from_[p]; k != no_index; k = another[k]) side_to[to(k)] = k;
    for (std::uint32_t k = side_from_[p]; k != no_index; k = another[k]) twin_[before[k]] = side_to[from(before[k])];
  }
}

}  // namespace ryosen::hull
