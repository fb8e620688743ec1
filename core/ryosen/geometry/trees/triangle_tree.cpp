#include "ryosen/geometry/trees/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ryosen/geometry/box.h"
#include "ryosen/geometry/trees/float_box.h"
#include "ryosen/geometry/trees/small_stack.h"

namespace ryosen {

namespace {

// Boxes whose distance from a point is not less than this, by floats that err by `slack`, hold nothing nearer.
float limit_for(double squared_distance, double slack) {
  if (!(squared_distance > 0)) return 0;
  const double distance = std::sqrt(squared_distance) + slack;
  return static_cast<float>(distance * distance * (1 + 0x1p-19));
}

}  // namespace

// A point that is near enough for floats to tell the boxes apart, in the tree's frame.
class TriangleTree::NearQuery {
 public:
  using Bound = float;

  NearQuery(const TriangleTree& tree, const glm::dvec3& p)
      : tree_(tree),
        p_(p),
        x_(Float4::all(static_cast<float>(p.x))),
        y_(Float4::all(static_cast<float>(p.y))),
        z_(Float4::all(static_cast<float>(p.z))),
        slack_(0x1p-20 * std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z), tree.reach_})) {}

  std::array<float, width> distances(const Node& node) const {
    if (node.turn != no_index) return turned_distances(node, tree_.turns_[node.turn]);
    return floats_of(square(node, 0, x_) + square(node, 1, y_) + square(node, 2, z_));
  }
  float limit(double squared_distance) const { return limit_for(squared_distance, slack_); }
  double slack() const { return slack_; }

 private:
  static Float4 square(const std::array<float, width>& lowest, const std::array<float, width>& highest, Float4 place) {
    const Float4 gap =
        larger(larger(Float4::load(lowest.data()) - place, place - Float4::load(highest.data())), Float4::all(0.0f));
    return gap * gap;
  }
  static Float4 square(const Node& node, std::size_t axis, Float4 place) {
    return square(node.lowest[axis], node.highest[axis], place);
  }

  std::array<float, width> turned_distances(const Node& node, const Turn& turn) const {
    const glm::dvec3 p = turn.axes * p_;
    Float4 within =
        square(node, 0, Float4::all(static_cast<float>(p.x))) + square(node, 1, Float4::all(static_cast<float>(p.y)));
    for (std::size_t way = 0; way < 2; ++way) {
      const auto along = [&](std::size_t k) {
        return static_cast<float>(glm::dot(turn.across[way][k], glm::dvec2(p)));
      };
      const Float4 place = Float4::of(along(0), along(1), along(2), along(3));
      within = larger(within, square(turn.lowest[way], turn.highest[way], place));
    }
    return floats_of(within + square(node, 2, Float4::all(static_cast<float>(p.z))));
  }

  const TriangleTree& tree_;
  glm::dvec3 p_;
  Float4 x_, y_, z_;
  double slack_;
};

// Any point.
class TriangleTree::FarQuery {
 public:
  using Bound = double;

  FarQuery(const TriangleTree& tree, const glm::dvec3& p)
      : tree_(tree), p_(p), slack_(0x1p-47 * std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)})) {}

  std::array<double, width> distances(const Node& node) const {
    const glm::dvec3 p = node.turn == no_index ? p_ : tree_.turns_[node.turn].axes * p_;
    std::array<double, width> result;
    for (std::size_t child = 0; child < width; ++child) {
      double sum = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double x = p[static_cast<int>(axis)];
        const double gap = std::max({double(node.lowest[axis][child]) - x, x - double(node.highest[axis][child]), 0.0});
        sum += gap * gap;
      }
      result[child] = sum;
    }
    return result;
  }
  double limit(double squared_distance) const {
    const double distance = std::sqrt(squared_distance) + slack_;
    return squared_distance > 0 ? distance * distance : 0.0;
  }

 private:
  const TriangleTree& tree_;
  glm::dvec3 p_;
  double slack_;
};

bool TriangleTree::is_far(const glm::dvec3& local) const {
  return std::max({std::abs(local.x), std::abs(local.y), std::abs(local.z)}) > 16 * reach_;
}

namespace {

constexpr auto any_triangle = [](std::uint32_t) { return true; };

}  // namespace

TriangleTree::Near TriangleTree::nearest(const glm::dvec3& p, std::uint32_t hint) const {
  const glm::dvec3 local = p - origin_;
  return is_far(local) ? nearest(FarQuery(*this, local), p, hint, any_triangle)
                       : nearest(NearQuery(*this, local), p, hint, any_triangle);
}

TriangleTree::Near TriangleTree::nearest_facing(const glm::dvec3& p, const glm::dvec3& direction) const {
  const glm::dvec3 local = p - origin_;
  const auto faces = [&](std::uint32_t t) { return glm::dot(area_normal(t), direction) > 0; };
  return is_far(local) ? nearest(FarQuery(*this, local), p, no_index, faces)
                       : nearest(NearQuery(*this, local), p, no_index, faces);
}

TriangleTree::Near TriangleTree::nearest_of(const glm::dvec3& p,
                                            const std::function<bool(std::uint32_t)>& is_asked) const {
  const glm::dvec3 local = p - origin_;
  return is_far(local) ? nearest(FarQuery(*this, local), p, no_index, is_asked)
                       : nearest(NearQuery(*this, local), p, no_index, is_asked);
}

std::size_t TriangleTree::triangles_asked_for(const glm::dvec3& p) const {
  std::size_t asked = 0;
  nearest(NearQuery(*this, p - origin_), p, no_index, [&](std::uint32_t) { return ++asked, true; });
  return asked;
}

template <class Query, class IsAsked>
TriangleTree::Near TriangleTree::nearest(const Query& query, const glm::dvec3& p, std::uint32_t hint,
                                         const IsAsked& is_asked) const {
  using Bound = typename Query::Bound;
  struct Entry {
    std::uint32_t node;
    Bound bound;
  };
  std::uint32_t best = hint;
  double best_square = std::numeric_limits<double>::infinity();
  Bound limit = std::numeric_limits<Bound>::infinity();
  if (hint != no_index) {
    best_square = squared(way(p, hint));
    limit = query.limit(best_square);
  }
  SmallStack<Entry> stack;
  stack.push({static_cast<std::uint32_t>(nodes_.size()) - 1, 0});
  while (!stack.empty()) {
    const Entry entry = stack.pop();
    if (!(entry.bound < limit)) continue;
    const Node& node = nodes_[entry.node];
    const std::array<Bound, width> bounds = query.distances(node);
    std::array<Entry, width> open;  // the nearest last
    std::size_t count = 0;
    for (std::uint32_t child = 0; child < width; ++child) {
      if (!(bounds[child] < limit)) continue;
      std::size_t at = count++;
      for (; at > 0 && open[at - 1].bound < bounds[child]; --at) open[at] = open[at - 1];
      open[at] = {node.first + child, bounds[child]};
    }
    if (!node.has_triangles) {
      for (std::size_t i = 0; i < count; ++i) stack.push(open[i]);
      continue;
    }
    for (std::size_t i = count; i-- > 0 && open[i].bound < limit;) {
      if (open[i].node == hint || !is_asked(open[i].node)) continue;
      const double square = squared(way(p, open[i].node));
      if (!(square < best_square)) continue;
      best_square = square;
      best = open[i].node;
      limit = query.limit(square);
    }
  }
  return {std::sqrt(best_square), best};
}

// Finds the nodes with triangles once for all points.
void TriangleTree::nearest(std::span<const glm::dvec3> points, std::span<Near> near) const {
  const Box box = box_of(points);
  const glm::dvec3 low = box.lowest - origin_, high = box.highest - origin_;
  std::array<std::uint32_t, most_shared> shared;
  std::size_t count = 0;
  const bool is_shared = !is_far(low) && !is_far(high) && find_shared(points, near, shared, count);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::dvec3& p = points[i];
    if (!is_shared) {
      near[i] = nearest(p, near[i].triangle);
      continue;
    }
    const std::uint32_t hint = near[i].triangle;
    const NearQuery query(*this, p - origin_);
    double best_square = near[i].distance * near[i].distance;
    float limit = query.limit(best_square);
    for (std::size_t k = 0; k < count; ++k) {
      const Node& node = nodes_[shared[k]];
      const std::array<float, width> bounds = query.distances(node);
      for (std::uint32_t child = 0; child < width; ++child) {
        if (!(bounds[child] < limit) || node.first + child == hint) continue;
        const double square = squared(way(p, node.first + child));
        if (!(square < best_square)) continue;
        best_square = square;
        near[i].triangle = node.first + child;
        limit = query.limit(square);
      }
    }
    near[i].distance = std::sqrt(best_square);
  }
}

bool TriangleTree::find_shared(std::span<const glm::dvec3> points, std::span<Near> near,
                               std::array<std::uint32_t, most_shared>& shared, std::size_t& count) const {
  double reach = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (near[i].triangle == no_index) return false;
    near[i].distance = distance(points[i], near[i].triangle);
    reach = std::max(reach, near[i].distance);
  }
  const Box box = box_of(points);
  const glm::dvec3 middle = box.middle() - origin_, half = 0.5 * (box.highest - box.lowest);
  const auto bounds_of = [](const glm::dvec3& m, const glm::dvec3& h) {
    const FloatBox around = rounded_outwards(m - h, m + h);
    return std::pair(floats_of(around.lowest), floats_of(around.highest));
  };
  const auto plain = bounds_of(middle, half);
  const float limit = limit_for(reach * reach, 0x1p-20 * 16 * reach_);
  SmallStack<std::uint32_t> stack;
  stack.push(static_cast<std::uint32_t>(nodes_.size()) - 1);
  while (!stack.empty()) {
    const std::uint32_t number = stack.pop();
    const Node& node = nodes_[number];
    std::pair<std::array<float, 4>, std::array<float, 4>> around = plain;
    if (node.turn != no_index) {
      const glm::dmat3& turn = turns_[node.turn].axes;
      around = bounds_of(turn * middle, glm::dmat3(glm::abs(turn[0]), glm::abs(turn[1]), glm::abs(turn[2])) * half);
    }
    const auto& [low, high] = around;
    Float4 sum = Float4::all(0.0f);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Float4 gap = larger(larger(Float4::load(node.lowest[axis].data()) - Float4::all(high[axis]),
                                       Float4::all(low[axis]) - Float4::load(node.highest[axis].data())),
                                Float4::all(0.0f));
      sum = sum + gap * gap;
    }
    const std::array<float, width> bounds = floats_of(sum);
    bool is_wanted = false;
    for (std::uint32_t child = 0; child < width; ++child) {
      if (!(bounds[child] < limit)) continue;
      is_wanted = true;
      if (!node.has_triangles) stack.push(node.first + child);
    }
    if (!is_wanted || !node.has_triangles) continue;
    if (count == shared.size()) return false;
    shared[count++] = number;
  }
  return true;
}

std::size_t TriangleTree::bytes() const {
  return points_.capacity() * sizeof(glm::dvec3) + corners_.capacity() * sizeof(corners_[0]) +
         owners_.capacity() * sizeof(std::uint32_t) + nodes_.capacity() * sizeof(Node) +
         turns_.capacity() * sizeof(turns_[0]);
}

}  // namespace ryosen
