// Boxes of a triangle tree that lie along what is in them.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <optional>

#include "ryosen/geometry/box.h"
#include "ryosen/geometry/trees/float_box.h"
#include "ryosen/geometry/trees/triangle_tree.h"

namespace ryosen {

namespace {

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
