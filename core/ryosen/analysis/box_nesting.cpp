#include "ryosen/analysis/box_nesting.h"

#include <algorithm>
#include <numeric>

namespace ryosen {

BoxNesting::BoxNesting(std::span<const Box> boxes)
    : boxes_(boxes.begin(), boxes.end()), order_(boxes.size()), rank_(boxes.size()), ranks_(boxes.size()) {
  // An enclosing box begins further left. Where both begin at one place neither lies inside the other.
  std::iota(order_.begin(), order_.end(), 0u);
  std::sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) {
    return boxes_[a].lowest.x != boxes_[b].lowest.x ? boxes_[a].lowest.x > boxes_[b].lowest.x : a < b;
  });
  std::iota(ranks_.begin(), ranks_.end(), 0u);
  for (const std::uint32_t rank : ranks_) rank_[order_[rank]] = rank;
  build(0, static_cast<std::uint32_t>(ranks_.size()));
}

std::uint32_t BoxNesting::build(std::uint32_t first, std::uint32_t last) {
  const auto at = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({{}, no_index, 0, first, last - first});
  for (std::uint32_t i = first; i < last; ++i) {
    Node& node = nodes_[at];
    node.box.add(box(ranks_[i]));
    node.first_rank = std::min(node.first_rank, ranks_[i]);
    node.last_rank = std::max(node.last_rank, ranks_[i]);
  }
  if (last - first <= leaf_size) return at;
  part(first, last);
  const std::uint32_t middle = first + (last - first) / 2;
  build(first, middle);
  nodes_[at].count = 0;
  const std::uint32_t second = build(middle, last);
  nodes_[at].first = second;
  return at;
}

// By place along the axis in which the boxes lie furthest apart for their size. Where they cover each other along all
// axes, by rank, so that the inner ones are found without looking at the outer ones.
void BoxNesting::part(std::uint32_t first, std::uint32_t last) {
  Box middles;
  glm::dvec3 sizes(0.0);
  for (std::uint32_t i = first; i < last; ++i) {
    const Box& b = box(ranks_[i]);
    middles.add(b.middle());
    sizes += (0.5 * b.highest - 0.5 * b.lowest) / static_cast<double>(last - first);
  }
  const glm::dvec3 width = 0.5 * middles.highest - 0.5 * middles.lowest;
  int axis = 0;
  for (int k = 1; k < 3; ++k)
    if (width[k] * sizes[axis] > width[axis] * sizes[k]) axis = k;
  const auto begin = ranks_.begin() + first, end = ranks_.begin() + last;
  std::nth_element(begin, begin + (last - first) / 2, end, [&](std::uint32_t a, std::uint32_t b) {
    const double x = box(a).middle()[axis], y = box(b).middle()[axis];
    return width[axis] > sizes[axis] && x != y ? x < y : a < b;
  });
}

}  // namespace ryosen
