// A static tree of boxes in space, by doubles: finds the boxes that a test lets through.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include "ryosen/geometry/box.h"

namespace ryosen {

// Built in O(n log n). Boxes are known by their numbers.
class BoxTree {
 public:
  BoxTree() = default;
  explicit BoxTree(std::vector<Box> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    if (!boxes_.empty()) build(0, static_cast<std::uint32_t>(boxes_.size()));
  }

  bool is_empty() const { return boxes_.empty(); }

  // Calls visit(number) for each box that may(box) lets through, which it must do for every box around one that it lets
  // through, until visit returns false; then so does this.
  template <class May, class Visit>
  bool visit(const May& may, const Visit& visit) const {
    for (std::uint32_t k = 0; k < nodes_.size();) {
      const Node& node = nodes_[k];
      if (!may(node.box)) {
        k = node.behind;
        continue;
      }
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
        if (may(boxes_[order_[i]]) && !visit(order_[i])) return false;
      ++k;
    }
    return true;
  }

  // The same, of two halves first into the one whose key(box) is less.
  template <class May, class Key, class Visit>
  bool visit_by(const May& may, const Key& key, const Visit& visit) const {
    std::vector<std::uint32_t> open;
    if (!nodes_.empty()) open.push_back(0);
    while (!open.empty()) {
      const std::uint32_t k = open.back();
      open.pop_back();
      if (!may(nodes_[k].box)) continue;
      for (std::uint32_t i = nodes_[k].first; i < nodes_[k].first + nodes_[k].count; ++i)
        if (may(boxes_[order_[i]]) && !visit(order_[i])) return false;
      if (nodes_[k].count > 0) continue;
      const std::uint32_t left = k + 1, right = nodes_[left].behind;
      const bool is_right_first = key(nodes_[right].box) < key(nodes_[left].box);
      open.push_back(is_right_first ? left : right);
      open.push_back(is_right_first ? right : left);
    }
    return true;
  }

 private:
  static constexpr std::uint32_t leaf_size = 4;
  // In depth-first order; `behind` is the first one that is not below this one.
  struct Node {
    Box box;
    std::uint32_t behind = 0, first = 0, count = 0;
  };

  void build(std::uint32_t first, std::uint32_t last) {
    const std::size_t at = nodes_.size();
    nodes_.emplace_back();
    Box box, centers;
    for (std::uint32_t i = first; i < last; ++i) {
      box.add(boxes_[order_[i]]);
      centers.add(boxes_[order_[i]].middle());
    }
    if (last - first <= leaf_size) {
      nodes_[at].first = first;
      nodes_[at].count = last - first;
    } else {
      const glm::dvec3 width = centers.highest - centers.lowest;
      const int axis = width.x >= width.y && width.x >= width.z ? 0 : width.y >= width.z ? 1 : 2;
      const std::uint32_t middle = first + (last - first) / 2;
      std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                       [&](std::uint32_t a, std::uint32_t b) {
                         const double x = boxes_[a].middle()[axis], y = boxes_[b].middle()[axis];
                         return x != y ? x < y : a < b;
                       });
      build(first, middle);
      build(middle, last);
    }
    nodes_[at].box = box;
    nodes_[at].behind = static_cast<std::uint32_t>(nodes_.size());
  }

  std::vector<Box> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace ryosen
