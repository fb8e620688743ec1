#include "ryosen/textbook/steps/hull/step_builder.h"

#include <algorithm>

#include "ryosen/base/sort_unique.h"
#include "ryosen/geometry/place_keys.h"
#include "ryosen/geometry/predicates.h"
#include "ryosen/hull/distinct_points.h"

namespace ryosen::hull {

using Index = std::uint32_t;
using Table = DcelChange::Table;
using Field = DcelChange::Field;

FirstPoints first_points(std::span<const glm::dvec3> points, std::span<const Index> order) {
  FirstPoints first;
  for (const Index i : order) {
    const auto place = [&](std::size_t k) -> const glm::dvec3& { return points[first.numbers[k]]; };
    const bool is_new = first.dimension == -1  ? true
                        : first.dimension == 0 ? points[i] != place(0)
                        : first.dimension == 1 ? !are_collinear(place(0), place(1), points[i])
                                               : orient3d(place(0), place(1), place(2), points[i]) != 0;
    if (!is_new) continue;
    first.numbers[static_cast<std::size_t>(++first.dimension)] = i;
    if (first.dimension == 3) break;
  }
  return first;
}

StepBuilder::StepBuilder(std::span<const glm::dvec3> points, HullOrder order, std::vector<Index> numbers,
                         const FirstPoints& first)
    : points_(points),
      order_(order),
      numbers_(std::move(numbers)),
      first_(first.numbers.begin(), first.numbers.begin() + first.dimension + 1),
      is_planar_(first.dimension == 2) {
  records_.vertices.reserve(points.size());
  for (const glm::dvec3& p : points) records_.vertices.push_back({p, no_index});
  list_.resize(points.size(), no_index);
  seen_element_.resize(points.size(), no_index);
  is_taken_.resize(points.size(), false);
}

const HullStep* StepBuilder::next(bool tells_why) {
  if (steps_done_ == step_count()) return nullptr;
  reuse_rows();
  step_ = {};
  step_.is_planar = is_planar_;
  step_.half_edge_rows = records_.half_edges.size();
  step_.face_rows = records_.faces.size();
  if (steps_done_++ > 0) {
    take(next_point(), tells_why);
    return &step_;
  }
  step_.kind = HullStep::Kind::begin;
  step_.points = first_;
  step_.point = first_.back();
  begin();
  for (const Index i : first_) is_taken_[i] = true;
  for (const Index i : numbers_) {
    if (is_taken_[i]) continue;
    const auto seen = std::find_if(step_.made.begin(), step_.made.end(), [&](Index e) { return sees(i, e); });
    if (seen != step_.made.end()) keep_outside(i, *seen);
  }
  for (const Index element : step_.made) announce(element);
  return &step_;
}

void StepBuilder::reuse_rows() {
  free_half_edges_.insert(free_half_edges_.end(), freed_half_edges_.rbegin(), freed_half_edges_.rend());
  free_faces_.insert(free_faces_.end(), freed_faces_.rbegin(), freed_faces_.rend());
  freed_half_edges_.clear();
  freed_faces_.clear();
}

void StepBuilder::take(Index p, bool tells_why) {
  is_taken_[p] = true;
  step_.point = p;
  step_.kind = HullStep::Kind::inside;
  if (seen_element_[p] == no_index) {
    if (tells_why) tell_why_not(p);
    return;
  }
  step_.kind = HullStep::Kind::extend;
  extend(p, seen_element_[p]);
  hand_on(p);
}

void StepBuilder::hand_on(Index p) {
  for (const Index gone : step_.seen) {
    Index i = outside_[gone].first;
    outside_[gone] = {};
    while (i != no_index) {
      const Index after = list_[i];
      seen_element_[i] = no_index;
      if (i != p)
        if (const Index element = new_element_of(i); element != no_index) keep_outside(i, element);
      i = after;
    }
  }
  for (const Index element : step_.made) announce(element);
}

void StepBuilder::keep_outside(Index p, Index element) {
  seen_element_[p] = element;
  Outside& outside = outside_[element];
  list_[p] = outside.first;
  outside.first = p;
  if (order_ != HullOrder::farthest) return;
  const double d = distance(element, p);
  if (outside.farthest != no_index && (d < outside.distance || (d == outside.distance && p > outside.farthest))) return;
  outside.farthest = p;
  outside.distance = d;
}

void StepBuilder::announce(Index element) {
  if (order_ == HullOrder::farthest && outside_[element].farthest != no_index)
    heap_.push({outside_[element].distance, outside_[element].farthest});
}

Index StepBuilder::next_point() {
  while (!heap_.empty()) {
    const Index p = heap_.top().point;
    heap_.pop();
    // Else what it stood for is gone.
    if (!is_taken_[p] && seen_element_[p] != no_index && outside_[seen_element_[p]].farthest == p) return p;
  }
  while (is_taken_[numbers_[next_number_]]) ++next_number_;
  return numbers_[next_number_];
}

void StepBuilder::set(Table table, Index row, Field field, Index value) {
  DcelChange change{table, row, field, no_index, value};
  Index& written = cell(records_, change);
  change.old_value = written;
  if (written == value) return;
  written = value;
  step_.changes.push_back(change);
}

void StepBuilder::join(Index h, Index k) {
  set_half_edge(h, Field::next, k);
  set_half_edge(k, Field::prev, h);
}

void StepBuilder::pair(Index h, Index k) {
  set_half_edge(h, Field::twin, k);
  set_half_edge(k, Field::twin, h);
}

static Index row_for_new(std::vector<Index>& free, std::size_t size) {
  if (free.empty()) return static_cast<Index>(size);
  const Index row = free.back();
  free.pop_back();
  return row;
}

Index StepBuilder::new_half_edge() {
  const Index row = row_for_new(free_half_edges_, records_.half_edges.size());
  records_.half_edges.resize(std::max(records_.half_edges.size(), row + std::size_t{1}));
  return row;
}

Index StepBuilder::new_face() {
  const Index row = row_for_new(free_faces_, records_.faces.size());
  records_.faces.resize(std::max(records_.faces.size(), row + std::size_t{1}));
  return row;
}

void StepBuilder::remove_half_edge(Index h) {
  const Index v = origin(h);
  if (records_.vertices[v].incident_edge == h) set(Table::vertex, v, Field::incident_edge, no_index);
  for (const Field field : {Field::origin, Field::twin, Field::next, Field::prev, Field::face})
    set_half_edge(h, field, no_index);
  freed_half_edges_.push_back(h);
}

void StepBuilder::note_made(Index element) {
  if (element >= outside_.size()) outside_.resize(element + std::size_t{1});
  outside_[element] = {};
  step_.made.push_back(element);
  ++made_so_far_;
}

ConvexHull StepBuilder::hull() const {
  // Of equal points the lowest number, whichever was taken in.
  std::vector<Index> by_place;
  for (Index i = 0; i < points_.size(); ++i)
    if (is_taken_[i]) by_place.push_back(i);
  std::sort(by_place.begin(), by_place.end(),
            [&](Index a, Index b) { return points_[a] == points_[b] ? a < b : is_before(points_[a], points_[b]); });
  std::vector<Index> lowest(points_.size());
  for (std::size_t k = 0; k < by_place.size(); ++k) {
    const Index i = by_place[k];
    lowest[i] = k > 0 && points_[i] == points_[by_place[k - 1]] ? lowest[by_place[k - 1]] : i;
  }
  ConvexHull result;
  result.dimension = is_planar_ ? 2 : 3;
  result.used = by_place.size();
  FacetList list = in_order(facets(), lowest);
  result.vertices = list.corners;
  sort_unique(result.vertices);
  result.corners = std::move(list.corners);
  result.facet_offsets = std::move(list.offsets);
  return result;
}

}  // namespace ryosen::hull
