// A static tree of boxes in space, by doubles: finds the boxes that a test lets through.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <numeric>
#include <vector>

namespace ryosen {

struct SpaceBox {
  glm::dvec3 lowest{std::numeric_limits<double>::infinity()};
  glm::dvec3 highest{-std::numeric_limits<double>::infinity()};

  void add(const glm::dvec3& p) {
    lowest = glm::min(lowest, p);
    highest = glm::max(highest, p);
  }
  void add(const SpaceBox& box) {
    lowest = glm::min(lowest, box.lowest);
    highest = glm::max(highest, box.highest);
  }
  // Touching counts.
  bool overlaps(const SpaceBox& b) const {
    for (int axis = 0; axis < 3; ++axis)
      if (highest[axis] < b.lowest[axis] || b.highest[axis] < lowest[axis]) return false;
    return true;
  }
};

// Built in O(n log n). Boxes are known by their numbers.
class BoxTree {
 public:
  BoxTree() = default;
  explicit BoxTree(std::vector<SpaceBox> boxes) : boxes_(std::move(boxes)), order_(boxes_.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    if (!boxes_.empty()) build(0, static_cast<std::uint32_t>(boxes_.size()));
  }

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

 private:
  static constexpr std::uint32_t leaf_size = 4;
  // In depth-first order; `behind` is the first one that is not below this one.
  struct Node {
    SpaceBox box;
    std::uint32_t behind = 0, first = 0, count = 0;
  };

  void build(std::uint32_t first, std::uint32_t last) {
    const std::size_t at = nodes_.size();
    nodes_.emplace_back();
    SpaceBox box, centers;
    for (std::uint32_t i = first; i < last; ++i) {
      box.add(boxes_[order_[i]]);
      centers.add(center(order_[i]));
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
                         const double x = center(a)[axis], y = center(b)[axis];
                         return x != y ? x < y : a < b;
                       });
      build(first, middle);
      build(middle, last);
    }
    nodes_[at].box = box;
    nodes_[at].behind = static_cast<std::uint32_t>(nodes_.size());
  }
  glm::dvec3 center(std::uint32_t i) const { return 0.5 * boxes_[i].lowest + 0.5 * boxes_[i].highest; }

  std::vector<SpaceBox> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace ryosen
