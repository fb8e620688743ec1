#include "ryosen/geometry/sweep.h"

#include <algorithm>
#include <array>

#include "ryosen/geometry/predicates.h"

namespace ryosen {

namespace {

constexpr std::uint32_t none = 0xffffffffu;  // no node, no corner, no interval

// A sequence in a balanced binary tree (treap), for orders that only a descent from the root can determine.
//
// Nodes are numbers chosen by the caller, each in the tree at most once. To search, descend from root() by left() and
// right(). Inserting and erasing cost O(log n) expected for any input, because priorities are hashes of the numbers.
// Deterministic: the same calls give the same tree.
class OrderedTree {
 public:
  void clear() {
    links_.clear();
    root_ = none;
  }

  std::uint32_t root() const { return root_; }
  std::uint32_t left(std::uint32_t node) const { return links_[node].child[0]; }
  std::uint32_t right(std::uint32_t node) const { return links_[node].child[1]; }

  // Inserts a node at the empty link where a search ended; `parent` is none for an empty tree.
  void attach(std::uint32_t node, std::uint32_t parent, bool to_the_right) {
    if (links_.size() <= node) links_.resize(node + 1);
    links_[node] = {{none, none}, parent, hash(node)};
    if (parent == none) {
      root_ = node;
      return;
    }
    links_[parent].child[to_the_right] = node;
    while (links_[node].parent != none && links_[links_[node].parent].priority < links_[node].priority) rotate_up(node);
  }

  // Inserts a node directly after another one.
  void insert_after(std::uint32_t node, std::uint32_t before) {
    std::uint32_t place = right(before);
    if (place == none) return attach(node, before, true);
    while (left(place) != none) place = left(place);
    attach(node, place, false);
  }

  void erase(std::uint32_t node) {
    while (left(node) != none || right(node) != none) {
      const std::uint32_t l = left(node), r = right(node);
      const bool use_left = r == none || (l != none && links_[l].priority > links_[r].priority);
      rotate_up(use_left ? l : r);
    }
    replace_below(links_[node].parent, node, none);
  }

 private:
  struct Links {
    std::uint32_t child[2] = {none, none};
    std::uint32_t parent = none;
    std::uint32_t priority = 0;
  };

  static std::uint32_t hash(std::uint32_t x) {
    x = (x ^ (x >> 16u)) * 0x7feb352du;
    x = (x ^ (x >> 15u)) * 0x846ca68bu;
    return x ^ (x >> 16u);
  }

  void rotate_up(std::uint32_t node) {
    const std::uint32_t parent = links_[node].parent;
    const std::uint32_t above = links_[parent].parent;
    const bool was_right = links_[parent].child[1] == node;
    const std::uint32_t inner = links_[node].child[!was_right];
    links_[parent].child[was_right] = inner;
    if (inner != none) links_[inner].parent = parent;
    links_[node].child[!was_right] = parent;
    links_[parent].parent = node;
    links_[node].parent = above;
    replace_below(above, parent, node);
  }

  // At the link to a child, or at the root where there is no parent.
  void replace_below(std::uint32_t parent, std::uint32_t child, std::uint32_t by) {
    if (parent == none)
      root_ = by;
    else
      links_[parent].child[links_[parent].child[1] == child] = by;
  }

  std::vector<Links> links_;
  std::uint32_t root_ = none;
};

// Triangulates during the sweep [Hertel83]: an interval is the interior between two adjacent sides on the sweep line,
// and its untriangulated part is bounded above by a reflex chain of corners. Each corner cuts off the triangles visible
// from it, so no diagonals are stored, and after sorting the work is linear apart from O(log n) searches. Buffers are
// kept between calls.
class SweepTriangulator {
 public:
  bool run(const PlanarLoops& loops, SweepMode mode, std::vector<CornerTriangle>& out) {
    points_ = loops.points;
    out_ = &out;
    mode_ = mode;
    nodes_.clear();
    intervals_.clear();
    tree_.clear();
    open_ = 0;
    if (!link_corners(loops)) return false;
    sort_corners();
    const std::size_t before = out.size();
    for (const std::uint32_t v : order_)
      if (!visit(v)) return false;
    if (open_ != 0 || out.size() - before + 4 != order_.size() + 2 * live_loops_) return false;
    out.insert(out.end(), repeated_.begin(), repeated_.end());
    return true;
  }

 private:
  // The two sides of an interval, and the two ends of its chain.
  static constexpr std::size_t left = 0, right = 1;

  // A node of an interval's chain. After a split a corner is in two chains.
  struct ChainNode {
    std::uint32_t corner;
    std::array<std::uint32_t, 2> beside;  // towards the left side and towards the right one
  };

  // The interior between the side from the left end down to its successor and the side from the right end down to its
  // predecessor.
  struct Interval {
    std::array<std::uint32_t, 2> ends;  // chain nodes of the upper ends of the left and of the right side
    std::uint32_t low;                  // chain node of the lowest corner, the last one added
  };

  // Links each corner to its neighbours, skipping repeated positions; false if a loop has fewer than two distinct
  // positions.
  bool link_corners(const PlanarLoops& loops) {
    for (auto* const column : {&next_, &prev_, &rank_, &owner_[left], &owner_[right]})
      column->assign(loops.points.size(), none);
    order_.clear();
    repeated_.clear();
    live_loops_ = 0;
    std::uint32_t first = 0;
    for (const std::uint32_t end : loops.ends) {
      if (end == first) continue;
      ++live_loops_;
      const std::size_t before = order_.size();
      link_loop(first, end);
      if (order_.size() - before < 2) return false;
      first = end;
    }
    return true;
  }

  void link_loop(std::uint32_t first, std::uint32_t last) {
    const std::uint32_t count = last - first;
    std::uint32_t begin = 0;  // a corner that differs from the one before it
    while (begin < count && points_[first + begin] == points_[first + (begin + count - 1) % count]) ++begin;
    if (begin == count) return;
    const std::size_t loop_start = order_.size();
    std::uint32_t kept = none;
    std::size_t run_start = repeated_.size();
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t corner = first + (begin + i) % count;
      // The fan (kept, this, following) is completed by the next corner, whichever it is.
      if (repeated_.size() > run_start) repeated_.back()[2] = corner;
      if (kept != none && points_[corner] == points_[kept]) {
        repeated_.push_back({kept, corner, none});
        continue;
      }
      run_start = repeated_.size();
      order_.push_back(corner);
      kept = corner;
    }
    if (repeated_.size() > run_start) repeated_.back()[2] = order_[loop_start];
    for (std::size_t i = loop_start; i < order_.size(); ++i) {
      const std::uint32_t following = i + 1 < order_.size() ? order_[i + 1] : order_[loop_start];
      next_[order_[i]] = following;
      prev_[following] = order_[i];
    }
  }

  // Top to bottom; at equal height the left point is higher, as if the plane were rotated infinitesimally.
  bool is_above(std::uint32_t a, std::uint32_t b) const {
    const glm::dvec2 &p = points_[a], &q = points_[b];
    return p.y > q.y || (p.y == q.y && p.x < q.x);
  }

  // Tie-break for corners at one position: first those that end an interval above, last those that start one below.
  int kind_of(std::uint32_t v) const {
    const bool prev_above = is_above(prev_[v], v), next_above = is_above(next_[v], v);
    if (prev_above && next_above) return bend(v) >= 0 ? 0 : 1;
    if (prev_above || next_above) return 2;
    return bend(v) < 0 ? 3 : 4;
  }

  void sort_corners() {
    std::sort(order_.begin(), order_.end(), [this](std::uint32_t a, std::uint32_t b) {
      if (points_[a] != points_[b]) return is_above(a, b);
      const int kind_a = kind_of(a), kind_b = kind_of(b);
      return kind_a != kind_b ? kind_a < kind_b : a < b;
    });
    for (std::uint32_t i = 0; i < order_.size(); ++i) rank_[order_[i]] = i;
  }

  int turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return orient2d(points_[a], points_[b], points_[c]);
  }
  int bend(std::uint32_t v) const { return turn(prev_[v], v, next_[v]); }

  bool visit(std::uint32_t v) {
    const bool prev_above = rank_[prev_[v]] < rank_[v], next_above = rank_[next_[v]] < rank_[v];
    if (prev_above && next_above) return visit_below_both(v);
    if (prev_above) return visit_side(v, owner_[left][prev_[v]], left);
    if (next_above) return visit_side(v, owner_[right][next_[v]], right);
    return visit_above_both(v);
  }

  bool visit_side(std::uint32_t v, std::uint32_t interval, std::size_t side) {
    return interval != none && extend(interval, v, side);
  }

  // Both neighbours are higher (end or merge vertex): the two sides close one interval or join two.
  bool visit_below_both(std::uint32_t v) {
    const std::uint32_t on_right = owner_[left][prev_[v]], on_left = owner_[right][next_[v]];
    if (on_left == none || on_right == none) return false;
    if (on_left == on_right) return finish(v, on_left);
    if (mode_ == SweepMode::strict && bend(v) > 0) return false;
    return merge(v, on_left, on_right);
  }

  // Both neighbours are lower (split or start vertex): a reflex corner splits the interval it lies in, a convex one
  // starts a new one.
  bool visit_above_both(std::uint32_t v) {
    const int bend_of_v = bend(v);
    std::uint32_t parent = none, found = none;
    bool is_right = false;
    for (std::uint32_t node = tree_.root(); node != none;) {
      const int place = place_of(node, v, bend_of_v < 0);
      if (place == 0) {
        found = node;
        if (bend_of_v <= 0 || mode_ == SweepMode::strict) break;
      }
      parent = node;
      is_right = place >= 0;
      node = is_right ? tree_.right(node) : tree_.left(node);
    }
    if (bend_of_v < 0 && found == none) return false;
    if (bend_of_v <= 0 && found != none) return split(v, found);
    if (found != none && mode_ == SweepMode::strict) return false;
    const std::uint32_t node = add_node(v, none, none), interval = add_interval(node, node, node);
    owner_[left][v] = owner_[right][v] = interval;
    tree_.attach(interval, parent, is_right);
    return true;
  }

  // -1 where a corner lies left of an interval, 0 where it lies inside, 1 right of it. If it lies on a side of the
  // interval its own sides decide: those of a reflex corner are inside the interval, those of a convex one outside.
  int place_of(std::uint32_t interval, std::uint32_t v, bool reflex) const {
    for (const std::size_t side : {left, right}) {
      const std::uint32_t end = nodes_[intervals_[interval].ends[side]].corner;
      const std::uint32_t below = side == left ? next_[end] : prev_[end];
      const int inside = side == left ? 1 : -1;  // the turn to what lies there
      const int of_v = inside * turn(end, below, v);
      if (of_v < 0) return -inside;
      if (of_v > 0) continue;
      const int of_prev = inside * turn(end, below, prev_[v]), of_next = inside * turn(end, below, next_[v]);
      if (reflex ? of_prev < 0 || of_next < 0 : of_prev <= 0 && of_next <= 0) return -inside;
    }
    return 0;
  }

  bool split(std::uint32_t v, std::uint32_t interval) {
    const std::uint32_t low = intervals_[interval].low, back = intervals_[interval].ends[right];
    const std::uint32_t twin = add_node(nodes_[low].corner, none, nodes_[low].beside[right]);
    nodes_[low].beside[right] = none;
    const std::uint32_t behind = add_interval(twin, back == low ? twin : back, twin);
    tree_.insert_after(behind, interval);
    intervals_[interval].ends[right] = low;
    if (!extend(interval, v, right) || !extend(behind, v, left)) return false;
    owner_[right][nodes_[intervals_[behind].ends[right]].corner] = behind;
    return true;
  }

  bool merge(std::uint32_t v, std::uint32_t on_left, std::uint32_t on_right) {
    if (!cut(on_left, v, right) || !cut(on_right, v, left)) return false;
    Interval &whole = intervals_[on_left], &gone = intervals_[on_right];
    whole.low = add_node(v, whole.ends[right], gone.ends[left]);
    whole.ends[right] = gone.ends[right];
    tree_.erase(on_right);
    --open_;
    owner_[right][nodes_[whole.ends[right]].corner] = on_left;
    return true;
  }

  bool finish(std::uint32_t v, std::uint32_t interval) {
    std::uint32_t node = intervals_[interval].ends[left];
    for (std::uint32_t after = nodes_[node].beside[right]; after != none; after = nodes_[node].beside[right]) {
      if (!emit(nodes_[after].corner, nodes_[node].corner, v)) return false;
      node = after;
    }
    tree_.erase(interval);
    --open_;
    return true;
  }

  bool emit(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (mode_ == SweepMode::strict && turn(a, b, c) < 0) return false;
    out_->push_back({a, b, c});
    return true;
  }

  // Makes a new corner the end of an interval on one side, below the triangles that it cuts off.
  bool extend(std::uint32_t interval, std::uint32_t v, std::size_t side) {
    if (!cut(interval, v, side)) return false;
    Interval& here = intervals_[interval];
    here.low = side == left ? add_node(v, none, here.ends[left]) : add_node(v, here.ends[right], none);
    here.ends[side] = here.low;
    owner_[side][v] = interval;
    return true;
  }

  // Cuts off the triangles visible from a new corner on one side. Chain corners lower than their predecessor are on the
  // opposite side and all visible; higher ones are on the same side and visible while the chain bends towards v.
  bool cut(std::uint32_t interval, std::uint32_t v, std::size_t side) {
    const std::size_t inwards = 1 - side;
    std::uint32_t end = intervals_[interval].ends[side];
    for (std::uint32_t inner = nodes_[end].beside[inwards]; inner != none; inner = nodes_[end].beside[inwards]) {
      std::uint32_t a = nodes_[end].corner, b = nodes_[inner].corner;
      const bool opposite = rank_[b] > rank_[a];
      if (side == left) std::swap(a, b);
      if (!opposite && turn(a, b, v) <= 0) break;
      if (!emit(a, b, v)) return false;
      end = inner;
    }
    nodes_[end].beside[side] = none;
    intervals_[interval].ends[side] = end;
    return true;
  }

  std::uint32_t add_node(std::uint32_t corner, std::uint32_t before, std::uint32_t after) {
    const auto node = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({corner, {before, after}});
    if (before != none) nodes_[before].beside[right] = node;
    if (after != none) nodes_[after].beside[left] = node;
    return node;
  }

  std::uint32_t add_interval(std::uint32_t front, std::uint32_t back, std::uint32_t low) {
    intervals_.push_back({{front, back}, low});
    ++open_;
    return static_cast<std::uint32_t>(intervals_.size() - 1);
  }

  std::span<const glm::dvec2> points_;
  std::vector<CornerTriangle>* out_ = nullptr;
  SweepMode mode_ = SweepMode::strict;
  std::vector<std::uint32_t> next_, prev_;
  std::vector<std::uint32_t> order_;                 // corners from top to bottom, without repeated ones
  std::vector<std::uint32_t> rank_;                  // index in order_
  std::array<std::vector<std::uint32_t>, 2> owner_;  // by corner: the interval whose left, or right, side starts here
  std::vector<CornerTriangle> repeated_;             // flat triangles that put repeated corners back in
  std::vector<ChainNode> nodes_;
  std::vector<Interval> intervals_;
  OrderedTree tree_;
  std::size_t open_ = 0;  // intervals in the tree
  std::size_t live_loops_ = 0;
};

}  // namespace

bool sweep_triangles(const PlanarLoops& loops, SweepMode mode, std::vector<CornerTriangle>& out) {
  thread_local SweepTriangulator triangulator;
  return triangulator.run(loops, mode, out);
}

}  // namespace ryosen
