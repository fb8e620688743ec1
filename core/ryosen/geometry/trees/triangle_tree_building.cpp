// How the tree of triangles is made, and which of its boxes lie along what is in them.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <optional>

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

// The order of the triangles in the tree.
std::vector<std::uint32_t> sorted(std::span<const glm::dvec3> positions, std::span<const Primitive> triangles,
                                  double scale) {
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

double surface(const glm::dvec3& size) { return size.x * size.y + size.y * size.z + size.z * size.x; }

// The rows are perpendicular to each other: the first goes along the longest side of all triangles, the second to the
// corner that is farthest from its line. None where all are at one place or on one line.
template <class ForEachTriangle>
std::optional<glm::dmat3> turn_along(const ForEachTriangle& for_each_triangle) {
  glm::dvec3 start{0}, along{0}, across{0};
  for_each_triangle([&](const std::array<glm::dvec3, 3>& t) {
    for (std::size_t i = 0; i < 3; ++i)
      if (const glm::dvec3 side = t[(i + 1) % 3] - t[i]; glm::dot(side, side) > glm::dot(along, along))
        along = side, start = t[i];
  });
  if (!(glm::dot(along, along) > 0)) return std::nullopt;
  along = glm::normalize(along);
  for_each_triangle([&](const std::array<glm::dvec3, 3>& t) {
    for (const glm::dvec3& corner : t) {
      const glm::dvec3 way = corner - start, beside = way - glm::dot(way, along) * along;
      if (glm::dot(beside, beside) > glm::dot(across, across)) across = beside;
    }
  });
  if (!(glm::dot(across, across) > 1e-24)) return std::nullopt;
  across = glm::normalize(across - glm::dot(across, along) * along);
  return glm::transpose(glm::dmat3(along, across, glm::cross(along, across)));
}

// The directions across the long sides that lean the most to either side, in the plane of the first two axes.
template <class ForEachTriangle>
std::array<glm::dvec2, 2> across_long_sides(const glm::dmat3& axes, const ForEachTriangle& for_each_triangle) {
  double longest = 0;
  const auto for_each_side = [&](const auto& visit) {
    for_each_triangle([&](const std::array<glm::dvec3, 3>& t) {
      for (std::size_t i = 0; i < 3; ++i) visit(glm::dvec2(axes * (t[(i + 1) % 3] - t[i])));
    });
  };
  for_each_side([&](const glm::dvec2& side) { longest = std::max(longest, std::abs(side.x)); });
  if (!(longest > 1e-100)) return {glm::dvec2(0, 1), glm::dvec2(0, 1)};
  constexpr double any = std::numeric_limits<double>::infinity();
  double least = any, most = -any;  // slopes
  glm::dvec2 lowest(1, 0), highest(1, 0);
  for_each_side([&](const glm::dvec2& side) {
    if (std::abs(side.x) < 0.5 * longest) return;
    const double slope = side.y / side.x;
    if (slope < least) least = slope, lowest = side;
    if (slope > most) most = slope, highest = side;
  });
  const auto across = [](const glm::dvec2& side) { return glm::normalize(glm::dvec2(-side.y, side.x)); };
  return {across(lowest), across(highest)};
}

}  // namespace

TriangleTree::TriangleTree(std::span<const glm::dvec3> positions, std::span<const Primitive> triangles, double scale) {
  if (triangles.empty()) return;
  take(positions, triangles, sorted(positions, triangles, scale), scale);
  const Box box = box_of(points_);
  origin_ = box.middle();
  const glm::dvec3 half = 0.5 * (box.highest - box.lowest);
  reach_ = std::max({half.x, half.y, half.z});
  add_levels();
  turn_slender_nodes();
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

TriangleTree::Content TriangleTree::content_of(const Node& node, std::span<const Content> below) const {
  Content content{no_index, 0, 0};
  for (std::uint32_t child = 0; child < width; ++child) {
    if (!(node.lowest[0][child] <= node.highest[0][child])) continue;
    const std::uint32_t at = node.first + child;
    Content one{at, at + 1, 0};
    if (!node.has_triangles) {
      one = below[at];
    } else {
      const auto [a, b, c] = places(at);
      one.area = 0.5 * glm::length(glm::cross(b - a, c - a));
    }
    content = {std::min(content.begin, one.begin), std::max(content.end, one.end), content.area + one.area};
  }
  return content;
}

// Those in whose boxes there is far more room than there are triangles.
void TriangleTree::turn_slender_nodes() {
  constexpr double slender = 16;  // the square of the diagonal by the area
  std::vector<Content> contents;
  contents.reserve(nodes_.size());
  for (Node& node : nodes_) {
    contents.push_back(content_of(node, contents));
    double diagonal = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double size = double(*std::max_element(node.highest[axis].begin(), node.highest[axis].end())) -
                          double(*std::min_element(node.lowest[axis].begin(), node.lowest[axis].end()));
      diagonal += size * size;
    }
    if (diagonal > slender * contents.back().area) turn(node, contents.back(), contents);
  }
}

void TriangleTree::turn(Node& node, const Content& content, std::span<const Content> below) {
  const auto triangles_in = [&](const Content& range) {
    return [this, range](const auto& visit) {
      for (std::uint32_t t = range.begin; t < range.end; ++t) visit(places(t));
    };
  };
  const auto axes = turn_along(triangles_in(content));
  if (!axes) return;
  Turn turned_to{*axes, {}, {}, {}};
  Box plain, turned;
  std::array<Box, width> boxes, between;
  for (std::uint32_t child = 0; child < width; ++child) {
    if (!(node.lowest[0][child] <= node.highest[0][child])) continue;
    const std::uint32_t at = node.first + child;
    const auto for_each_triangle = triangles_in(node.has_triangles ? Content{at, at + 1, 0} : below[at]);
    const auto across = across_long_sides(*axes, for_each_triangle);
    for_each_triangle([&](const std::array<glm::dvec3, 3>& t) {
      for (const glm::dvec3& corner : t) {
        plain.add(corner);
        const glm::dvec3 p = *axes * (corner - origin_);
        boxes[child].add(p);
        between[child].add({glm::dot(across[0], glm::dvec2(p)), glm::dot(across[1], glm::dvec2(p)), 0});
      }
    });
    for (std::size_t way = 0; way < 2; ++way) turned_to.across[way][child] = across[way];
    turned.add(boxes[child].lowest);
    turned.add(boxes[child].highest);
  }
  if (!(2 * surface(turned.highest - turned.lowest) < surface(plain.highest - plain.lowest))) return;
  node.turn = static_cast<std::uint32_t>(turns_.size());
  const auto set = [](auto& lowest, auto& highest, std::size_t child, const Box& box) {
    const FloatBox rounded = rounded_outwards(box.lowest, box.highest);
    const std::array<float, 4> low = floats_of(rounded.lowest), high = floats_of(rounded.highest);
    for (std::size_t axis = 0; axis < lowest.size(); ++axis) {
      lowest[axis][child] = low[axis];
      highest[axis][child] = high[axis];
    }
  };
  for (std::size_t child = 0; child < width; ++child) {
    if (boxes[child].is_empty()) continue;
    set(node.lowest, node.highest, child, boxes[child]);
    set(turned_to.lowest, turned_to.highest, child, between[child]);
  }
  turns_.push_back(turned_to);
}

}  // namespace ryosen
