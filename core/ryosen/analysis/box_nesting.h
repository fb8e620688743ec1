// Which boxes enclose a box, inner ones first.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <queue>
#include <span>
#include <utility>
#include <vector>

#include "ryosen/base/handle.h"
#include "ryosen/geometry/box.h"

namespace ryosen {

// A tree of boxes, split by position where they lie side by side and by rank in the order below where they overlap.
// Built in O(n log n). Boxes are known by their numbers.
class BoxNesting {
 public:
  explicit BoxNesting(std::span<const Box> boxes);

  // All boxes, each before those that enclose it.
  std::span<const std::uint32_t> order() const { return order_; }
  // Asks is_it(number) of the boxes that enclose box `number`, in that order, until one is; else no_index.
  template <class IsIt>
  std::uint32_t first_around(std::uint32_t number, const IsIt& is_it) const;

 private:
  static constexpr std::uint32_t leaf_size = 4;
  struct Node {
    Box box;
    std::uint32_t first_rank, last_rank;
    std::uint32_t first, count;  // a leaf's range of ranks_; else the second child and 0, the first child follows
  };

  std::uint32_t build(std::uint32_t first, std::uint32_t last);
  void part(std::uint32_t first, std::uint32_t last);
  const Box& box(std::uint32_t rank) const { return boxes_[order_[rank]]; }

  std::vector<Box> boxes_;
  std::vector<std::uint32_t> order_, rank_;  // numbers by rank, and the inverse
  std::vector<std::uint32_t> ranks_;         // in the order of the leaves
  std::vector<Node> nodes_;
};

template <class IsIt>
std::uint32_t BoxNesting::first_around(std::uint32_t number, const IsIt& is_it) const {
  const std::uint32_t own = rank_[number];
  using Entry = std::pair<std::uint32_t, std::uint32_t>;  // the lowest rank that may be below, and the node or none
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> waiting;
  const auto wait = [&](std::uint32_t k) {
    const Node& node = nodes_[k];
    if (node.last_rank > own && node.box.encloses(boxes_[number])) waiting.emplace(std::max(node.first_rank, own), k);
  };
  wait(0);
  while (!waiting.empty()) {
    const auto [rank, k] = waiting.top();
    waiting.pop();
    if (k == no_index) {
      if (is_it(order_[rank])) return order_[rank];
      continue;
    }
    const Node& node = nodes_[k];
    if (node.count == 0) {
      wait(k + 1);
      wait(node.first);
    }
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
      if (ranks_[i] > own && box(ranks_[i]).encloses(boxes_[number])) waiting.emplace(ranks_[i], no_index);
  }
  return no_index;
}

}  // namespace ryosen
