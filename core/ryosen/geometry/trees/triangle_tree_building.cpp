// How the tree of triangles is made.
#include <algorithm>
#include <limits>

#include "ryosen/base/interruption.h"
#include "ryosen/geometry/box.h"
#include "ryosen/geometry/trees/float_box.h"
#include "ryosen/geometry/trees/triangle_tree.h"

namespace ryosen {

namespace {

constexpr float no_bound = std::numeric_limits<float>::infinity();

// The middle of a triangle, to sort by.
struct SortedTriangle {
  std::array<float, 3> middle;
  std::uint32_t index;
};

// Parts ranges such that every block of 4, 16, 64 ... triangles counted from the first is a compact one.
void part(std::span<SortedTriangle> items) {
  while (items.size() > 4) {
    stop_if_interrupted();
    std::array<float, 3> low, high;
    low.fill(no_bound);
    high.fill(-no_bound);
    for (const SortedTriangle& item : items)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(low[axis], item.middle[axis]);
        high[axis] = std::max(high[axis], item.middle[axis]);
      }
    std::size_t axis = 0;
    for (std::size_t other : {1u, 2u})
      if (high[other] - low[other] > high[axis] - low[axis]) axis = other;
    std::size_t half = 4;
    while (2 * half < items.size()) half *= 2;
    std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
                     [axis](const SortedTriangle& a, const SortedTriangle& b) {
                       return a.middle[axis] != b.middle[axis] ? a.middle[axis] < b.middle[axis] : a.index < b.index;
                     });
    part(items.first(half));
    items = items.subspan(half);
  }
}

}  // namespace

TriangleTree::TriangleTree(std::span<const glm::dvec3> positions, std::span<const Primitive> triangles, double scale) {
  if (triangles.empty()) return;
  take(positions, triangles, sorted(positions, triangles, scale), scale);
  choose_origin();
  add_levels();
  turn_slender_nodes();
}

std::vector<std::uint32_t> TriangleTree::sorted(std::span<const glm::dvec3> positions,
                                                std::span<const Primitive> triangles, double scale) const {
  std::vector<SortedTriangle> items;
  reserve_large(items, triangles.size());
  for (const Primitive& triangle : triangles) {
    const auto& [a, b, c] = triangle.vertices;
    const glm::dvec3 middle = (positions[a] * scale + positions[b] * scale + positions[c] * scale) / 3.0;
    items.push_back({{static_cast<float>(middle.x), static_cast<float>(middle.y), static_cast<float>(middle.z)},
                     static_cast<std::uint32_t>(items.size())});
  }
  part(items);
  std::vector<std::uint32_t> order;
  reserve_large(order, items.size());
  for (const SortedTriangle& item : items) order.push_back(item.index);
  return order;
}

void TriangleTree::take(std::span<const glm::dvec3> positions, std::span<const Primitive> triangles,
                        std::span<const std::uint32_t> order, double scale) {
  reserve_large(corners_, order.size());
  reserve_large(owners_, order.size());
  std::vector<std::uint32_t> number(positions.size(), no_index);
  for (const std::uint32_t i : order) {
    std::array<std::uint32_t, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t& point = number[triangles[i].vertices[k]];
      if (point == no_index) {
        point = static_cast<std::uint32_t>(points_.size());
        points_.push_back(positions[triangles[i].vertices[k]] * scale);
      }
      corners[k] = point;
    }
    corners_.push_back(corners);
    owners_.push_back(triangles[i].owner);
  }
}

void TriangleTree::choose_origin() {
  const Box box = box_of(points_);
  origin_ = box.middle();
  const glm::dvec3 half = 0.5 * (box.highest - box.lowest);
  reach_ = std::max({half.x, half.y, half.z});
}

void TriangleTree::add_levels() {
  const auto set = [](Node& node, std::size_t child, const FloatBox& box) {
    const std::array<float, 4> low = floats_of(box.lowest), high = floats_of(box.highest);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      node.lowest[axis][child] = low[axis];
      node.highest[axis][child] = high[axis];
    }
  };
  const auto whole = [](const Node& node) {
    FloatBox box = empty_box();
    for (std::size_t child = 0; child < width; ++child) {
      const auto at = [child](const auto& rows) {
        return Float4::of(rows[0][child], rows[1][child], rows[2][child], 0.0f);
      };
      grow(box, {at(node.lowest), at(node.highest)});
    }
    return box;
  };
  const std::uint32_t count = size();
  nodes_.reserve(count / 3 + 24);
  for (std::uint32_t first = 0; first < count; first += width) {
    Node& node = nodes_.emplace_back();
    node.first = first;
    node.has_triangles = 1;
    for (std::uint32_t child = 0; child < width; ++child) {
      FloatBox box = empty_box();
      if (first + child < count) {
        const auto [a, b, c] = places(first + child);
        box = rounded_outwards(glm::min(glm::min(a, b), c) - origin_, glm::max(glm::max(a, b), c) - origin_);
      }
      set(node, child, box);
    }
  }
  std::size_t begin = 0;
  while (nodes_.size() - begin > 1) {
    const std::size_t end = nodes_.size();
    for (std::size_t first = begin; first < end; first += width) {
      Node node;
      node.first = static_cast<std::uint32_t>(first);
      node.has_triangles = 0;
      for (std::size_t child = 0; child < width; ++child)
        set(node, child, first + child < end ? whole(nodes_[first + child]) : empty_box());
      nodes_.push_back(node);
    }
    begin = end;
  }
}

}  // namespace ryosen
