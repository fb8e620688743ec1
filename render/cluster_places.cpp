#include "render/cluster_places.h"

#include <algorithm>

#include "core/base/parallel.h"

namespace ryosen {
namespace {

constexpr std::size_t steps_each = 20;  // of work for each cluster, for threads_for

struct Depth {
  double depth;
  std::uint32_t cluster;
};

PixelRect place_of(const Cluster& cluster, const glm::mat4& clip_from_buffer, Size size) {
  return screen_bounds(cluster.box, clip_from_buffer, size, 1);
}

double depth_of(const Cluster& cluster, const glm::dmat4& view_from_buffer) {
  if (cluster.box.empty()) return 0;
  const glm::dvec3 centre = 0.5 * (glm::dvec3(cluster.box.min) + glm::dvec3(cluster.box.max));
  return -(view_from_buffer * glm::dvec4(centre, 1.0)).z;
}

}  // namespace

void ClusterPlaces::place_all(std::span<const Cluster> clusters, const glm::dmat4& view_from_buffer,
                              const glm::mat4& clip_from_buffer, Size size) {
  const auto count = static_cast<std::uint32_t>(clusters.size());
  std::vector<Depth> depths(count);
  places_.resize(count);
  order_.resize(count);
  for_each_part(count, threads_for(count * steps_each), [&](unsigned, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t i = begin; i < end; ++i) {
      depths[i] = {depth_of(clusters[i], view_from_buffer), i};
      places_[i] = place_of(clusters[i], clip_from_buffer, size);
    }
  });
  std::stable_sort(depths.begin(), depths.end(), [](const Depth& a, const Depth& b) { return a.depth < b.depth; });
  std::transform(depths.begin(), depths.end(), order_.begin(), [](const Depth& depth) { return depth.cluster; });
}

void ClusterPlaces::place(std::span<const Cluster> clusters, std::span<const std::uint32_t> changed,
                          const glm::mat4& clip_from_buffer, Size size) {
  for (auto i = static_cast<std::uint32_t>(order_.size()); i < clusters.size(); ++i) order_.push_back(i);
  places_.resize(order_.size());
  for (const std::uint32_t cluster : changed) places_[cluster] = place_of(clusters[cluster], clip_from_buffer, size);
}

std::vector<std::uint32_t> ClusterPlaces::inside(const PixelRect& rect) const {
  std::vector<std::uint32_t> found;
  for (const std::uint32_t cluster : order_)
    if (overlap(places_[cluster], rect)) found.push_back(cluster);
  return found;
}

std::size_t ClusterPlaces::triangles_inside(std::span<const Cluster> clusters, const PixelRect& rect) const {
  std::size_t triangles = 0;
  for (std::size_t i = 0; i < places_.size(); ++i)
    if (overlap(places_[i], rect)) triangles += clusters[i].count;
  return triangles;
}

std::size_t ClusterPlaces::remove_hidden(std::span<const Cluster> clusters, const Occlusion& occlusion,
                                         const glm::mat4& clip_from_buffer, int scale,
                                         std::vector<std::uint32_t>& numbers) const {
  std::vector<std::uint8_t> hidden(numbers.size());
  const auto count = static_cast<std::uint32_t>(numbers.size());
  for_each_part(count, threads_for(count * steps_each), [&](unsigned, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t i = begin; i < end; ++i) {
      const PixelRect& at = places_[numbers[i]];
      const PixelRect place{at.x0 * scale, at.y0 * scale, at.x1 * scale, at.y1 * scale};
      hidden[i] = occlusion.hides(clusters[numbers[i]].box, place, clip_from_buffer);
    }
  });
  std::size_t triangles = 0, kept = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (hidden[i])
      triangles += clusters[numbers[i]].count;
    else
      numbers[kept++] = numbers[i];
  }
  numbers.resize(kept);
  return triangles;
}

}  // namespace ryosen
