#include "ryosen/hull/hull_parts.h"

#include "ryosen/analysis/disjoint_sets.h"

namespace ryosen {

ConvexHull hull_of_some(std::span<const glm::dvec3> points, std::span<const std::uint32_t> numbers,
                        Progress& progress) {
  std::vector<glm::dvec3> places;
  places.reserve(numbers.size());
  for (const std::uint32_t i : numbers) places.push_back(points[i]);
  ConvexHull hull = convex_hull(places, progress);
  for (std::uint32_t& i : hull.vertices) i = numbers[i];
  for (std::uint32_t& i : hull.corners) i = numbers[i];
  return hull;
}

std::vector<std::vector<std::uint32_t>> joined_points(const IndexedMesh& list, const PointPairs& edges) {
  const auto count = static_cast<std::uint32_t>(list.positions.size());
  DisjointSets sets(count);
  for (std::size_t f = 0; f < list.face_count(); ++f)
    for (std::uint32_t k = list.face_offsets[f] + 1; k < list.face_offsets[f + 1]; ++k)
      sets.join(list.corners[k - 1], list.corners[k]);
  for (const auto& [a, b] : edges) sets.join(a, b);
  std::vector<std::vector<std::uint32_t>> parts;
  std::vector<std::uint32_t> part_of(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t root = sets.root(i);  // the lowest one
    if (root == i) {
      part_of[i] = static_cast<std::uint32_t>(parts.size());
      parts.emplace_back();
    }
    parts[part_of[root]].push_back(i);
  }
  return parts;
}

}  // namespace ryosen
