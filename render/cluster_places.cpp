#include "render/cluster_places.h"

#include <algorithm>
#include <glm/vec4.hpp>

#include "ryosen/base/parallel.h"

namespace ryosen {

namespace {

constexpr std::size_t steps_each = 20;  // of work for each cluster, for threads_for

struct Depth {
  double depth;
  std::uint32_t group;
};

PixelRect place_of(const DrawBox& box, const glm::mat4& clip_from_buffer, Size size) {
  return screen_bounds(box, clip_from_buffer, size, 1);
}

double depth_of(const DrawBox& box, const glm::dmat4& view_from_buffer) {
  if (box.empty()) return 0;
  const glm::dvec3 centre = 0.5 * (glm::dvec3(box.min) + glm::dvec3(box.max));
  return -(view_from_buffer * glm::dvec4(centre, 1.0)).z;
}

}  // namespace

DrawBox ClusterPlaces::box_of(std::span<const Cluster> clusters, std::uint32_t group) const {
  DrawBox box;
  const std::size_t first = std::size_t{group} * neighbours_;
  for (std::size_t i = first; i < std::min(clusters.size(), first + neighbours_); ++i) box.add(clusters[i].box);
  return box;
}

void ClusterPlaces::place_all(std::span<const Cluster> clusters, std::uint32_t neighbours,
                              const glm::dmat4& view_from_buffer, const glm::mat4& clip_from_buffer, Size size) {
  neighbours_ = neighbours;
  const std::uint32_t groups = groups_for(clusters.size());
  std::vector<Depth> depths(groups);
  places_.resize(groups);
  order_.resize(groups);
  for_each_part(groups, threads_for(groups * steps_each), [&](unsigned, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t i = begin; i < end; ++i) {
      const DrawBox box = box_of(clusters, i);
      depths[i] = {depth_of(box, view_from_buffer), i};
      places_[i] = place_of(box, clip_from_buffer, size);
    }
  });
  std::stable_sort(depths.begin(), depths.end(), [](const Depth& a, const Depth& b) { return a.depth < b.depth; });
  std::transform(depths.begin(), depths.end(), order_.begin(), [](const Depth& depth) { return depth.group; });
}

void ClusterPlaces::place(std::span<const Cluster> clusters, std::span<const std::uint32_t> changed,
                          const glm::mat4& clip_from_buffer, Size size) {
  for (auto i = static_cast<std::uint32_t>(order_.size()); i < groups_for(clusters.size()); ++i) order_.push_back(i);
  places_.resize(order_.size());
  for (const std::uint32_t cluster : changed) {
    const std::uint32_t group = cluster / neighbours_;
    places_[group] = place_of(box_of(clusters, group), clip_from_buffer, size);
  }
}

std::vector<std::uint32_t> ClusterPlaces::inside(std::span<const Cluster> clusters, const PixelRect& rect) const {
  std::vector<std::uint32_t> found;
  const auto count = static_cast<std::uint32_t>(clusters.size());
  for (const std::uint32_t group : order_)
    if (overlap(places_[group], rect))
      for (std::uint32_t i = group * neighbours_; i < std::min(count, (group + 1) * neighbours_); ++i)
        found.push_back(i);
  return found;
}

std::size_t ClusterPlaces::triangles_inside(std::span<const Cluster> clusters, const PixelRect& rect) const {
  std::size_t triangles = 0;
  for (std::size_t i = 0; i < clusters.size(); ++i)
    if (overlap(places_[i / neighbours_], rect)) triangles += clusters[i].count;
  return triangles;
}

std::size_t ClusterPlaces::remove_hidden(std::span<const Cluster> clusters, const Occlusion& occlusion,
                                         const glm::mat4& clip_from_buffer, int scale,
                                         std::vector<std::uint32_t>& numbers) const {
  std::vector<std::uint8_t> hidden(numbers.size());
  const auto count = static_cast<std::uint32_t>(numbers.size());
  for_each_part(count, threads_for(count * steps_each), [&](unsigned, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t i = begin; i < end; ++i) {
      const PixelRect& at = places_[numbers[i] / neighbours_];
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

void Occlusion::read(const DrawTarget& drawn, const PixelRect& rect) {
  rect_ = rect;
  columns_ = (rect.width() + square - 1) / square;
  const int rows = (rect.height() + square - 1) / square;
  depths_.resize(static_cast<std::size_t>(rect.width()) * static_cast<std::size_t>(rect.height()));
  drawn.read_depth(rect, depths_.data());
  farthest_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows), 0);
  const float* depth = depths_.data();
  for (int y = 0; y < rect.height(); ++y) {
    float* const of_row = farthest_.data() + std::ptrdiff_t{y / square} * columns_;
    for (int x = 0; x < rect.width(); ++x) of_row[x / square] = std::max(of_row[x / square], *depth++);
  }
}

bool Occlusion::hides(const DrawBox& box, const PixelRect& place, const glm::mat4& clip_from_buffer) const {
  float nearest = 1, farthest = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    const glm::vec4 clip = clip_from_buffer * glm::vec4(box.corner(i), 1.0f);
    if (!(clip.w > 0 && clip.z >= -clip.w)) return false;
    const float depth = 0.5f * clip.z / clip.w + 0.5f;
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  // The depth of a pixel at the rim of a steep triangle may lie beyond that of its corners.
  constexpr float rounding = 1e-5f;
  const float certain = nearest - (farthest - nearest) - rounding;
  const PixelRect inside = intersection(place, rect_);
  if (inside.empty()) return true;
  for (int y = (inside.y0 - rect_.y0) / square; y <= (inside.y1 - 1 - rect_.y0) / square; ++y)
    for (int x = (inside.x0 - rect_.x0) / square; x <= (inside.x1 - 1 - rect_.x0) / square; ++x)
      if (farthest_[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x)] >=
          certain)
        return false;
  return true;
}

}  // namespace ryosen
