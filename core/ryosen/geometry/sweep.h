// Plane-sweep triangulation of polygons with holes, top to bottom.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "ryosen/geometry/ordered_tree.h"
#include "ryosen/geometry/triangulate.h"

namespace ryosen {

// The corners of one or more loops, numbered consecutively; the interior is left of every side.
struct PlanarLoops {
  std::span<const glm::dvec2> points;
  std::span<const std::uint32_t> ends;  // one past the last corner of each loop
};

// Triangulates during the sweep [Hertel83]: an interval is the interior between two adjacent sides on the sweep line,
// and its untriangulated part is bounded above by a reflex chain of corners. Each corner cuts off the triangles visible
// from it, so no diagonals are stored, and after sorting the work is linear apart from O(log n) searches. Buffers are
// kept between calls.
class SweepTriangulator {
 public:
  enum class Mode {
    strict,   // gives up if a triangle would be inverted: the loops are not even weakly simple
    tolerant  // continues, so that loops with a few crossings get a triangulation with a few inverted triangles
  };

  // Appends the triangles to `out`; false if it failed, with an incomplete set in `out`.
  bool run(const PlanarLoops& loops, Mode mode, std::vector<CornerTriangle>& out);

 private:
  static constexpr std::uint32_t none = 0xffffffffu;

  // A node of an interval's chain. After a split a corner is in two chains.
  struct ChainNode {
    std::uint32_t corner;
    std::uint32_t before;  // towards the left side
    std::uint32_t after;   // towards the right side
  };

  // The interior between the side from front down to its successor and the side from back down to its predecessor.
  struct Interval {
    std::uint32_t front;  // chain node of the left side's upper end
    std::uint32_t back;   // chain node of the right side's upper end
    std::uint32_t low;    // chain node of the lowest corner, the last one added
  };

  enum class Side { left, inside, right };

  bool link_corners(const PlanarLoops& loops);
  void link_loop(std::uint32_t first, std::uint32_t last);
  void sort_corners();
  bool is_above(std::uint32_t a, std::uint32_t b) const;
  int kind_of(std::uint32_t v) const;

  bool visit(std::uint32_t v);
  bool visit_below_both(std::uint32_t v);
  bool visit_above_both(std::uint32_t v);
  bool visit_left(std::uint32_t v);
  bool visit_right(std::uint32_t v);
  bool start(std::uint32_t v);
  bool split(std::uint32_t v, std::uint32_t interval);
  bool merge(std::uint32_t v, std::uint32_t left, std::uint32_t right);
  bool finish(std::uint32_t v, std::uint32_t interval);

  Side side_of(std::uint32_t interval, std::uint32_t v, bool reflex) const;
  int turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
  bool emit(std::uint32_t a, std::uint32_t b, std::uint32_t c);
  bool cut_from_left(std::uint32_t interval, std::uint32_t v);
  bool cut_from_right(std::uint32_t interval, std::uint32_t v);
  std::uint32_t add_node(std::uint32_t corner, std::uint32_t before, std::uint32_t after);
  std::uint32_t add_interval(std::uint32_t front, std::uint32_t back, std::uint32_t low);

  std::span<const glm::dvec2> points_;
  std::vector<CornerTriangle>* out_ = nullptr;
  Mode mode_ = Mode::strict;
  std::vector<std::uint32_t> next_, prev_;
  std::vector<std::uint32_t> order_;       // corners from top to bottom, without repeated ones
  std::vector<std::uint32_t> rank_;        // index in order_
  std::vector<std::uint32_t> left_owner_;  // by corner: the interval whose left side starts here
  std::vector<std::uint32_t> right_owner_;
  std::vector<CornerTriangle> repeated_;  // flat triangles that put repeated corners back in
  std::vector<ChainNode> nodes_;
  std::vector<Interval> intervals_;
  OrderedTree tree_;
  std::size_t open_ = 0;  // intervals in the tree
  std::size_t live_loops_ = 0;
  std::uint32_t place_parent_ = none;  // where the last search ended
  bool place_right_ = false;
};

}  // namespace ryosen
