#include "ryosen/geometry/sweep.h"

#include <algorithm>

#include "ryosen/geometry/predicates.h"

namespace ryosen {

bool SweepTriangulator::run(const PlanarLoops& loops, Mode mode, std::vector<CornerTriangle>& out) {
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
  for (const std::uint32_t v : order_) {
    if (!visit(v)) return false;
  }
  if (open_ != 0 || out.size() - before + 4 != order_.size() + 2 * live_loops_) return false;
  out.insert(out.end(), repeated_.begin(), repeated_.end());
  return true;
}

// Links each corner to its neighbours, skipping repeated positions; false if a loop has fewer than two distinct
// positions.
bool SweepTriangulator::link_corners(const PlanarLoops& loops) {
  const std::size_t count = loops.points.size();
  next_.assign(count, none);
  prev_.assign(count, none);
  rank_.assign(count, none);
  left_owner_.assign(count, none);
  right_owner_.assign(count, none);
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

void SweepTriangulator::link_loop(std::uint32_t first, std::uint32_t last) {
  const std::uint32_t count = last - first;
  std::uint32_t begin = 0;  // a corner that differs from the one before it
  while (begin < count && points_[first + begin] == points_[first + (begin + count - 1) % count]) ++begin;
  if (begin == count) return;
  const std::size_t loop_start = order_.size();
  std::vector<CornerTriangle>& repeated = repeated_;
  std::uint32_t kept = none;
  std::size_t run_start = repeated.size();
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t corner = first + (begin + i) % count;
    if (kept != none && points_[corner] == points_[kept]) {
      // The fan (kept, this, following) is completed by the next corner, whichever it is.
      if (repeated.size() > run_start) repeated.back()[2] = corner;
      repeated.push_back({kept, corner, none});
      continue;
    }
    if (repeated.size() > run_start) repeated.back()[2] = corner;
    run_start = repeated.size();
    order_.push_back(corner);
    kept = corner;
  }
  if (repeated.size() > run_start) repeated.back()[2] = order_[loop_start];
  for (std::size_t i = loop_start; i < order_.size(); ++i) {
    const std::uint32_t following = i + 1 < order_.size() ? order_[i + 1] : order_[loop_start];
    next_[order_[i]] = following;
    prev_[following] = order_[i];
  }
}

// Top to bottom; at equal height the left point is higher, as if the plane were rotated infinitesimally.
bool SweepTriangulator::is_above(std::uint32_t a, std::uint32_t b) const {
  const glm::dvec2& p = points_[a];
  const glm::dvec2& q = points_[b];
  return p.y > q.y || (p.y == q.y && p.x < q.x);
}

// Tie-break for corners at one position: first those that end an interval above, last those that start one below.
int SweepTriangulator::kind_of(std::uint32_t v) const {
  const bool prev_above = is_above(prev_[v], v);
  const bool next_above = is_above(next_[v], v);
  if (prev_above && next_above) return turn(prev_[v], v, next_[v]) >= 0 ? 0 : 1;
  if (prev_above || next_above) return 2;
  return turn(prev_[v], v, next_[v]) < 0 ? 3 : 4;
}

void SweepTriangulator::sort_corners() {
  std::sort(order_.begin(), order_.end(), [this](std::uint32_t a, std::uint32_t b) {
    const glm::dvec2& p = points_[a];
    const glm::dvec2& q = points_[b];
    if (p.y != q.y) return p.y > q.y;
    if (p.x != q.x) return p.x < q.x;
    const int kind_a = kind_of(a);
    const int kind_b = kind_of(b);
    return kind_a != kind_b ? kind_a < kind_b : a < b;
  });
  for (std::uint32_t i = 0; i < order_.size(); ++i) rank_[order_[i]] = i;
}

int SweepTriangulator::turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  return orient2d(points_[a], points_[b], points_[c]);
}

bool SweepTriangulator::visit(std::uint32_t v) {
  const bool prev_above = rank_[prev_[v]] < rank_[v];
  const bool next_above = rank_[next_[v]] < rank_[v];
  if (prev_above && next_above) return visit_below_both(v);
  if (prev_above) return visit_left(v);
  if (next_above) return visit_right(v);
  return visit_above_both(v);
}

// Both neighbours are higher (end or merge vertex): the two sides close one interval or join two.
bool SweepTriangulator::visit_below_both(std::uint32_t v) {
  const std::uint32_t right = left_owner_[prev_[v]];
  const std::uint32_t left = right_owner_[next_[v]];
  if (left == none || right == none) return false;
  if (left == right) return finish(v, left);
  if (mode_ == Mode::strict && turn(prev_[v], v, next_[v]) > 0) return false;
  return merge(v, left, right);
}

// Both neighbours are lower (split or start vertex): a reflex corner splits the interval it lies in, a convex one
// starts a new one.
bool SweepTriangulator::visit_above_both(std::uint32_t v) {
  const int bend = turn(prev_[v], v, next_[v]);
  place_parent_ = none;
  std::uint32_t node = tree_.root();
  std::uint32_t found = none;
  while (node != none) {
    const Side side = side_of(node, v, bend < 0);
    if (side == Side::inside) {
      found = node;
      if (bend <= 0 || mode_ == Mode::strict) break;
    }
    place_parent_ = node;
    place_right_ = side != Side::left;
    node = place_right_ ? tree_.right(node) : tree_.left(node);
  }
  if (bend < 0) return found != none && split(v, found);
  if (bend == 0 && found != none) return split(v, found);
  if (found != none && mode_ == Mode::strict) return false;
  return start(v);
}

// Where a corner lies relative to an interval. If it lies on a side of the interval its own sides decide: those of a
// reflex corner are inside the interval, those of a convex one outside.
SweepTriangulator::Side SweepTriangulator::side_of(std::uint32_t interval, std::uint32_t v, bool reflex) const {
  const std::uint32_t front = nodes_[intervals_[interval].front].corner;
  const int from_left = turn(front, next_[front], v);
  if (from_left < 0) return Side::left;
  if (from_left == 0) {
    const int p = turn(front, next_[front], prev_[v]);
    const int n = turn(front, next_[front], next_[v]);
    if (reflex ? (p < 0 || n < 0) : (p <= 0 && n <= 0)) return Side::left;
  }
  const std::uint32_t back = nodes_[intervals_[interval].back].corner;
  const int from_right = turn(back, prev_[back], v);
  if (from_right > 0) return Side::right;
  if (from_right == 0) {
    const int p = turn(back, prev_[back], prev_[v]);
    const int n = turn(back, prev_[back], next_[v]);
    if (reflex ? (p > 0 || n > 0) : (p >= 0 && n >= 0)) return Side::right;
  }
  return Side::inside;
}

bool SweepTriangulator::visit_left(std::uint32_t v) {
  const std::uint32_t interval = left_owner_[prev_[v]];
  if (interval == none || !cut_from_left(interval, v)) return false;
  Interval& here = intervals_[interval];
  here.front = here.low = add_node(v, none, here.front);
  left_owner_[v] = interval;
  return true;
}

bool SweepTriangulator::visit_right(std::uint32_t v) {
  const std::uint32_t interval = right_owner_[next_[v]];
  if (interval == none || !cut_from_right(interval, v)) return false;
  Interval& here = intervals_[interval];
  here.back = here.low = add_node(v, here.back, none);
  right_owner_[v] = interval;
  return true;
}

bool SweepTriangulator::start(std::uint32_t v) {
  const std::uint32_t node = add_node(v, none, none);
  const std::uint32_t interval = add_interval(node, node, node);
  left_owner_[v] = right_owner_[v] = interval;
  tree_.attach(interval, place_parent_, place_right_);
  return true;
}

bool SweepTriangulator::split(std::uint32_t v, std::uint32_t interval) {
  const std::uint32_t low = intervals_[interval].low;
  const std::uint32_t twin = add_node(nodes_[low].corner, none, nodes_[low].after);
  const std::uint32_t back = intervals_[interval].back == low ? twin : intervals_[interval].back;
  nodes_[low].after = none;
  const std::uint32_t right = add_interval(twin, back, twin);
  tree_.insert_after(right, interval);
  intervals_[interval].back = low;
  if (!cut_from_right(interval, v) || !cut_from_left(right, v)) return false;
  Interval& on_left = intervals_[interval];
  on_left.back = on_left.low = add_node(v, on_left.back, none);
  Interval& on_right = intervals_[right];
  on_right.front = on_right.low = add_node(v, none, on_right.front);
  right_owner_[v] = interval;
  left_owner_[v] = right_owner_[nodes_[on_right.back].corner] = right;
  return true;
}

bool SweepTriangulator::merge(std::uint32_t v, std::uint32_t left, std::uint32_t right) {
  if (!cut_from_right(left, v) || !cut_from_left(right, v)) return false;
  const std::uint32_t node = add_node(v, intervals_[left].back, intervals_[right].front);
  intervals_[left].back = intervals_[right].back;
  intervals_[left].low = node;
  tree_.erase(right);
  --open_;
  right_owner_[nodes_[intervals_[left].back].corner] = left;
  return true;
}

bool SweepTriangulator::finish(std::uint32_t v, std::uint32_t interval) {
  std::uint32_t node = intervals_[interval].front;
  for (std::uint32_t after = nodes_[node].after; after != none; after = nodes_[node].after) {
    if (!emit(nodes_[after].corner, nodes_[node].corner, v)) return false;
    node = after;
  }
  tree_.erase(interval);
  --open_;
  return true;
}

bool SweepTriangulator::emit(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  if (mode_ == Mode::strict && turn(a, b, c) < 0) return false;
  out_->push_back({a, b, c});
  return true;
}

// Cuts off the triangles visible from a new corner on the left side. Chain corners lower than their predecessor are on
// the opposite side and all visible; higher ones are on the same side and visible while the chain bends towards v.
bool SweepTriangulator::cut_from_left(std::uint32_t interval, std::uint32_t v) {
  std::uint32_t front = intervals_[interval].front;
  for (std::uint32_t after = nodes_[front].after; after != none; after = nodes_[front].after) {
    const std::uint32_t a = nodes_[front].corner;
    const std::uint32_t b = nodes_[after].corner;
    const bool opposite = rank_[b] > rank_[a];
    if (!opposite && turn(b, a, v) <= 0) break;
    if (!emit(b, a, v)) return false;
    front = after;
  }
  nodes_[front].before = none;
  intervals_[interval].front = front;
  return true;
}

bool SweepTriangulator::cut_from_right(std::uint32_t interval, std::uint32_t v) {
  std::uint32_t back = intervals_[interval].back;
  for (std::uint32_t before = nodes_[back].before; before != none; before = nodes_[back].before) {
    const std::uint32_t a = nodes_[back].corner;
    const std::uint32_t b = nodes_[before].corner;
    const bool opposite = rank_[b] > rank_[a];
    if (!opposite && turn(a, b, v) <= 0) break;
    if (!emit(a, b, v)) return false;
    back = before;
  }
  nodes_[back].after = none;
  intervals_[interval].back = back;
  return true;
}

std::uint32_t SweepTriangulator::add_node(std::uint32_t corner, std::uint32_t before, std::uint32_t after) {
  const auto node = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({corner, before, after});
  if (before != none) nodes_[before].after = node;
  if (after != none) nodes_[after].before = node;
  return node;
}

std::uint32_t SweepTriangulator::add_interval(std::uint32_t front, std::uint32_t back, std::uint32_t low) {
  const auto interval = static_cast<std::uint32_t>(intervals_.size());
  intervals_.push_back({front, back, low});
  ++open_;
  return interval;
}

}  // namespace ryosen
