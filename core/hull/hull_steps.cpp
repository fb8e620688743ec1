#include "core/hull/hull_steps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <queue>

#include "core/base/count_text.h"
#include "core/base/sort_unique.h"
#include "core/geometry/is_finite.h"
#include "core/geometry/predicates.h"
#include "core/hull/distinct_points.h"
#include "core/hull/unite_facets.h"

namespace ryosen {

namespace {

using Index = std::uint32_t;
using forms::DcelRecords;
using Table = DcelChange::Table;
using Field = DcelChange::Field;

Index& cell(DcelRecords& records, const DcelChange& change) {
  if (change.table == Table::vertex) return records.vertices[change.row].incident_edge;
  if (change.table == Table::face) return records.faces[change.row].outer_component;
  DcelRecords::HalfEdgeRecord& h = records.half_edges[change.row];
  switch (change.field) {
    case Field::origin:
      return h.origin;
    case Field::twin:
      return h.twin;
    case Field::next:
      return h.next;
    case Field::prev:
      return h.prev;
    default:
      return h.face;
  }
}

void make_room(DcelRecords& records, const DcelChange& change) {
  if (change.table == Table::half_edge && change.row >= records.half_edges.size())
    records.half_edges.resize(change.row + std::size_t{1});
  if (change.table == Table::face && change.row >= records.faces.size())
    records.faces.resize(change.row + std::size_t{1});
}

}  // namespace

std::string_view id_of(Table table) {
  constexpr std::array<std::string_view, 3> ids{"vertex", "half_edge", "face"};
  return ids[static_cast<std::size_t>(table)];
}

std::string_view id_of(Field field) {
  constexpr std::array<std::string_view, 7> ids{"incident_edge", "origin", "twin",           "next",
                                                "prev",          "face",   "outer_component"};
  return ids[static_cast<std::size_t>(field)];
}

void apply(const HullStep& step, DcelRecords& records) {
  for (const DcelChange& change : step.changes) {
    make_room(records, change);
    cell(records, change) = change.new_value;
  }
}

void take_back(const HullStep& step, DcelRecords& records) {
  for (auto change = step.changes.rbegin(); change != step.changes.rend(); ++change)
    cell(records, *change) = change->old_value;
  records.half_edges.resize(step.half_edge_rows);
  records.faces.resize(step.face_rows);
}

Text caption(const HullStep& step) {
  const std::string p = std::to_string(step.point), seen = std::to_string(step.seen.size()),
                    horizon = std::to_string(step.horizon.size()), witness = std::to_string(step.witness);
  switch (step.kind) {
    case HullStep::Kind::begin:
      return {"Four points that span space make the first four faces.", "空間を張る 4 点で最初の四面体を作ります。"};
    case HullStep::Kind::inside:
      return {"Point " + p + " sees no face: it lies inside and changes nothing.",
              "点 " + p + " からはどの面も見えません。内部にあるため何も変わりません。"};
    case HullStep::Kind::on_face:
      return {"Point " + p + " sees no face and lies in the plane of face " + witness + ": it changes nothing.",
              "点 " + p + " からはどの面も見えず、面 " + witness + " の平面上にあるため、何も変わりません。"};
    case HullStep::Kind::equal:
      return {"Point " + p + " lies at the place of vertex " + witness + ": it changes nothing.",
              "点 " + p + " は頂点 " + witness + " と同じ位置にあるため、何も変わりません。"};
    default:
      break;
  }
  Text text{"Point " + p + " sees " + seen + (step.seen.size() == 1 ? " face" : " faces") +
                ": they go, and each of the " + horizon + " edges of the horizon makes a face with it.",
            "点 " + p + " から面 " + seen + " 枚が見えます。それらを削除し、ホライゾンの稜線 " + horizon +
                " 本のそれぞれと点を結んで新しい面を作ります。"};
  if (!step.united.empty())
    text = text + count_text(step.united.size(),
                             " One of them lies in the plane of its neighbour, and is one facet with it.",
                             " # of them lie in the plane of their neighbour, and are one facet with it.",
                             "うち # 枚は隣の面と同一平面上にあり、一枚の面にまとまります。");
  return text;
}

class HullSteps::Impl {
 public:
  Impl(std::span<const glm::dvec3> points, HullOrder order, std::uint64_t seed) : points_(points), order_(order) {
    const auto count = static_cast<Index>(points.size());
    if (order == HullOrder::random) {
      numbers_ = shuffled_numbers(count, seed);
    } else {
      numbers_.resize(count);
      std::iota(numbers_.begin(), numbers_.end(), 0u);
    }
    std::erase_if(numbers_, [&](Index i) { return !is_finite(points[i]); });
    for (const glm::dvec3& p : points) records_.vertices.push_back({p, no_index});
    list_.resize(count, no_index);
    seen_face_.resize(count, no_index);
    is_taken_.resize(count, false);
    find_first_points();
  }

  int dimension() const { return dimension_; }
  std::size_t step_count() const { return dimension_ < 3 ? 0 : numbers_.size() - 3; }
  const DcelRecords& records() const { return records_; }
  std::size_t faces_made() const { return faces_made_; }

  const HullStep* next() {
    if (steps_done_ == step_count()) return nullptr;
    step_ = {};
    step_.half_edge_rows = records_.half_edges.size();
    step_.face_rows = records_.faces.size();
    if (steps_done_++ == 0)
      begin();
    else
      take(next_point());
    return &step_;
  }

  ConvexHull hull() const;

 private:
  // The first four of the order that span space, as far as there are.
  void find_first_points() {
    for (const Index i : numbers_) {
      const auto place = [&](std::size_t k) -> const glm::dvec3& { return points_[first_[k]]; };
      const bool is_new = dimension_ == -1  ? true
                          : dimension_ == 0 ? points_[i] != place(0)
                          : dimension_ == 1 ? !are_collinear(place(0), place(1), points_[i])
                                            : orient3d(place(0), place(1), place(2), points_[i]) != 0;
      if (!is_new) continue;
      first_[static_cast<std::size_t>(++dimension_)] = i;
      if (dimension_ == 3) return;
    }
  }

  void set(Table table, Index row, Field field, Index value) {
    DcelChange change{table, row, field, no_index, value};
    make_room(records_, change);
    Index& written = cell(records_, change);
    change.old_value = written;
    if (written == value) return;
    written = value;
    step_.changes.push_back(change);
  }
  void set_half_edge(Index h, Field field, Index value) { set(Table::half_edge, h, field, value); }
  void join(Index h, Index k) {
    set_half_edge(h, Field::next, k);
    set_half_edge(k, Field::prev, h);
  }
  void pair(Index h, Index k) {
    set_half_edge(h, Field::twin, k);
    set_half_edge(k, Field::twin, h);
  }

  static Index row_for_new(std::vector<Index>& free, std::size_t size) {
    if (free.empty()) return static_cast<Index>(size);
    const Index row = free.back();
    free.pop_back();
    return row;
  }

  // Half-edges from a, b, c in turn; their twins are left to the caller. The half-edge from a.
  Index add_face(Index a, Index b, Index c) {
    const Index f = row_for_new(free_faces_, records_.faces.size());
    std::array<Index, 3> h{};
    const std::array<Index, 3> corners{a, b, c};
    for (std::size_t k = 0; k < 3; ++k) {
      h[k] = row_for_new(free_half_edges_, records_.half_edges.size());
      set_half_edge(h[k], Field::origin, corners[k]);
      set_half_edge(h[k], Field::face, f);
      set(Table::vertex, corners[k], Field::incident_edge, h[k]);
    }
    for (std::size_t k = 0; k < 3; ++k) join(h[k], h[(k + 1) % 3]);
    set(Table::face, f, Field::outer_component, h[0]);
    outside_.resize(std::max(outside_.size(), f + std::size_t{1}));
    outside_[f] = {};
    step_.made.push_back(f);
    ++faces_made_;
    return h[0];
  }

  Index origin(Index h) const { return records_.half_edges[h].origin; }
  Index next_of(Index h) const { return records_.half_edges[h].next; }
  Index twin(Index h) const { return records_.half_edges[h].twin; }
  Index face_of(Index h) const { return records_.half_edges[h].face; }
  std::array<Index, 3> corners_of(Index f) const {
    const Index h = records_.faces[f].outer_component;
    return {origin(h), origin(next_of(h)), origin(next_of(next_of(h)))};
  }
  int side(Index f, Index p) const {
    const std::array<Index, 3> c = corners_of(f);
    return orient3d(points_[c[0]], points_[c[1]], points_[c[2]], points_[p]);
  }
  bool sees(Index p, Index f) const { return side(f, p) > 0; }
  double distance(Index f, Index p) const {
    const std::array<Index, 3> c = corners_of(f);
    const glm::dvec3 normal = glm::cross(points_[c[1]] - points_[c[0]], points_[c[2]] - points_[c[0]]);
    const double height = glm::dot(normal, points_[p] - points_[c[0]]) / glm::length(normal);
    return std::isfinite(height) ? height : 0;
  }

  void begin() {
    std::array<Index, 4> b = first_;
    if (orient3d(points_[b[0]], points_[b[1]], points_[b[2]], points_[b[3]]) > 0) std::swap(b[1], b[2]);
    step_.kind = HullStep::Kind::begin;
    step_.points.assign(first_.begin(), first_.end());
    step_.point = first_[3];
    const std::array<std::array<Index, 3>, 4> corners{
        {{b[0], b[1], b[2]}, {b[1], b[0], b[3]}, {b[2], b[1], b[3]}, {b[0], b[2], b[3]}}};
    std::vector<Index> all;
    for (const auto& c : corners) {
      const Index h = add_face(c[0], c[1], c[2]);
      for (const Index k : {h, next_of(h), next_of(next_of(h))}) all.push_back(k);
    }
    for (const Index h : all)
      for (const Index k : all)
        if (h < k && origin(h) == origin(next_of(k)) && origin(k) == origin(next_of(h))) pair(h, k);
    for (const Index i : first_) is_taken_[i] = true;
    for (const Index i : numbers_)
      if (!is_taken_[i]) assign(i, step_.made);
    for (const Index f : step_.made) announce(f);
  }

  // To the first of these faces that it sees.
  void assign(Index i, const std::vector<Index>& faces) {
    seen_face_[i] = no_index;
    for (const Index f : faces) {
      if (!sees(i, f)) continue;
      seen_face_[i] = f;
      Outside& outside = outside_[f];
      list_[i] = outside.first;
      outside.first = i;
      if (order_ != HullOrder::farthest) return;
      const double d = distance(f, i);
      if (outside.farthest == no_index || d > outside.distance || (d == outside.distance && i < outside.farthest)) {
        outside.farthest = i;
        outside.distance = d;
      }
      return;
    }
  }

  void announce(Index f) {
    if (order_ == HullOrder::farthest && outside_[f].farthest != no_index)
      heap_.push({outside_[f].distance, outside_[f].farthest});
  }

  Index next_point() {
    while (!heap_.empty()) {
      const Index p = heap_.top().point;
      if (!is_taken_[p] && seen_face_[p] != no_index && outside_[seen_face_[p]].farthest == p) {
        heap_.pop();
        return p;
      }
      heap_.pop();  // what it stood for is gone
    }
    while (is_taken_[numbers_[next_number_]]) ++next_number_;
    return numbers_[next_number_];
  }

  void take(Index p) {
    is_taken_[p] = true;
    step_.point = p;
    if (seen_face_[p] == no_index) return tell_why_not(p);
    step_.kind = HullStep::Kind::extend;
    find_horizon(p);
    remove_seen();
    make_faces(p);
    hand_on(p);
  }

  void tell_why_not(Index p) {
    step_.kind = HullStep::Kind::inside;
    for (Index f = 0; f < records_.faces.size(); ++f) {
      if (records_.faces[f].outer_component == no_index || side(f, p) != 0) continue;
      if (step_.kind == HullStep::Kind::inside) {
        step_.kind = HullStep::Kind::on_face;
        step_.witness = f;
      }
      for (const Index corner : corners_of(f))
        if (points_[corner] == points_[p]) {
          step_.kind = HullStep::Kind::equal;
          step_.witness = corner;
          return;
        }
    }
  }

  // The seen faces by a search over neighbours; then the edges between them and the others, end to end: from one, turn
  // about its end through seen faces until the next.
  void find_horizon(Index p) {
    ++round_;
    mark_.resize(records_.faces.size(), 0);
    step_.seen.assign(1, seen_face_[p]);
    mark_[seen_face_[p]] = round_;
    Index start = no_index;
    for (std::size_t at = 0; at < step_.seen.size(); ++at) {
      Index h = records_.faces[step_.seen[at]].outer_component;
      for (int k = 0; k < 3; ++k, h = next_of(h)) {
        const Index beyond = face_of(twin(h));
        if (mark_[beyond] == round_) continue;
        if (sees(p, beyond)) {
          mark_[beyond] = round_;
          step_.seen.push_back(beyond);
        } else {
          start = h;
        }
      }
    }
    Index h = start;
    do {
      step_.horizon.push_back(twin(h));
      h = next_of(h);
      while (mark_[face_of(twin(h))] == round_) h = next_of(twin(h));
    } while (h != start);
  }

  void remove_seen() {
    for (const Index f : step_.seen) {
      const Index first = records_.faces[f].outer_component;
      for (const Index h : {first, next_of(first), next_of(next_of(first))}) dying_.push_back(h);
      set(Table::face, f, Field::outer_component, no_index);
    }
    for (const Index h : dying_) {
      const Index v = origin(h);
      if (records_.vertices[v].incident_edge == h) set(Table::vertex, v, Field::incident_edge, no_index);
      for (const Field field : {Field::origin, Field::twin, Field::next, Field::prev, Field::face})
        set_half_edge(h, field, no_index);
    }
    free_half_edges_.insert(free_half_edges_.end(), dying_.rbegin(), dying_.rend());
    dying_.clear();
  }

  void make_faces(Index p) {
    // The ends of an edge of the horizon, as a made face runs along it: against the half-edge that stays.
    const std::size_t count = step_.horizon.size();
    std::vector<Index> along(count);
    for (std::size_t k = 0; k < count; ++k) {
      const Index stays = step_.horizon[k];
      const Index a = origin(next_of(stays)), b = origin(stays);
      along[k] = add_face(a, b, p);
      pair(along[k], stays);
    }
    for (std::size_t k = 0; k < count; ++k) pair(next_of(along[k]), next_of(next_of(along[(k + 1) % count])));
    for (std::size_t k = 0; k < count; ++k) {
      const Index made = step_.made[k], beyond = face_of(step_.horizon[k]);
      const Index h = step_.horizon[k];
      if (side(made, origin(next_of(next_of(h)))) == 0) step_.united.emplace_back(made, beyond);
    }
  }

  void hand_on(Index p) {
    for (const Index f : step_.seen) {
      Index i = gone_first(f);
      while (i != no_index) {
        const Index after = list_[i];
        if (i != p) assign(i, step_.made);
        i = after;
      }
    }
    free_faces_.insert(free_faces_.end(), step_.seen.rbegin(), step_.seen.rend());
    for (const Index f : step_.made) announce(f);
  }

  Index gone_first(Index f) {
    const Index first = outside_[f].first;
    outside_[f] = {};
    return first;
  }

  struct Outside {
    Index first = no_index, farthest = no_index;
    double distance = 0;
  };
  struct Candidate {
    double distance;
    Index point;
    bool operator<(const Candidate& other) const {
      return distance != other.distance ? distance < other.distance : point > other.point;
    }
  };

  std::span<const glm::dvec3> points_;
  HullOrder order_;
  std::vector<Index> numbers_;  // of the finite points, in their order
  std::size_t next_number_ = 0, steps_done_ = 0, faces_made_ = 0;
  int dimension_ = -1;
  std::array<Index, 4> first_{};
  DcelRecords records_;
  HullStep step_;
  std::vector<Index> free_half_edges_, free_faces_, dying_;
  std::vector<Index> list_, seen_face_;  // of each point
  std::vector<bool> is_taken_;
  std::vector<Outside> outside_;  // of each face
  std::vector<Index> mark_;       // of each face the round in which it was seen
  std::priority_queue<Candidate> heap_;
  Index round_ = 0;
};

ConvexHull HullSteps::Impl::hull() const {
  if (dimension_ < 3) return convex_hull(points_);
  std::vector<Index> number(records_.faces.size(), no_index);
  std::vector<hull::HullTriangle> triangles;
  for (Index f = 0; f < records_.faces.size(); ++f)
    if (records_.faces[f].outer_component != no_index) {
      number[f] = static_cast<Index>(triangles.size());
      triangles.push_back({corners_of(f), {}});
    }
  for (Index f = 0; f < records_.faces.size(); ++f) {
    if (number[f] == no_index) continue;
    Index h = records_.faces[f].outer_component;
    for (Index& beside : triangles[number[f]].beside) {
      beside = number[face_of(twin(h))];
      h = next_of(h);
    }
  }
  // Of equal points the lowest number, whichever was taken in.
  std::vector<Index> by_place;
  for (Index i = 0; i < points_.size(); ++i)
    if (is_taken_[i]) by_place.push_back(i);
  const auto is_before = [&](Index a, Index b) {
    return points_[a] == points_[b] ? a < b : hull::is_before(points_[a], points_[b]);
  };
  std::sort(by_place.begin(), by_place.end(), is_before);
  std::vector<Index> lowest(points_.size());
  for (std::size_t k = 0; k < by_place.size(); ++k)
    lowest[by_place[k]] =
        k > 0 && points_[by_place[k]] == points_[by_place[k - 1]] ? lowest[by_place[k - 1]] : by_place[k];
  ConvexHull result;
  result.dimension = 3;
  result.used = by_place.size();
  hull::FacetList facets = hull::in_order(hull::unite_facets(points_, triangles), lowest);
  result.vertices = facets.corners;
  sort_unique(result.vertices);
  result.corners = std::move(facets.corners);
  result.facet_offsets = std::move(facets.offsets);
  return result;
}

HullSteps::HullSteps(std::span<const glm::dvec3> points, HullOrder order, std::uint64_t seed)
    : impl_(std::make_unique<Impl>(points, order, seed)) {}
HullSteps::~HullSteps() = default;
int HullSteps::dimension() const { return impl_->dimension(); }
std::size_t HullSteps::step_count() const { return impl_->step_count(); }
const HullStep* HullSteps::next() { return impl_->next(); }
const forms::DcelRecords& HullSteps::records() const { return impl_->records(); }
std::size_t HullSteps::faces_made() const { return impl_->faces_made(); }
ConvexHull HullSteps::hull() const { return impl_->hull(); }

forms::DcelRecords in_use(const forms::DcelRecords& records) {
  std::vector<Index> half_edge(records.half_edges.size(), no_index), face(records.faces.size(), no_index);
  forms::DcelRecords kept;
  kept.vertices = records.vertices;
  for (Index h = 0; h < half_edge.size(); ++h) {
    if (records.half_edges[h].origin == no_index) continue;
    half_edge[h] = static_cast<Index>(kept.half_edges.size());
    kept.half_edges.push_back(records.half_edges[h]);
  }
  for (Index f = 0; f < face.size(); ++f) {
    if (records.faces[f].outer_component == no_index) continue;
    face[f] = static_cast<Index>(kept.faces.size());
    kept.faces.push_back(records.faces[f]);
  }
  const auto renumber = [](Index& link, const std::vector<Index>& number) {
    if (link != no_index) link = number[link];
  };
  for (auto& v : kept.vertices) renumber(v.incident_edge, half_edge);
  for (auto& h : kept.half_edges) {
    for (Index* const link : {&h.twin, &h.next, &h.prev}) renumber(*link, half_edge);
    renumber(h.face, face);
  }
  for (auto& f : kept.faces) renumber(f.outer_component, half_edge);
  return kept;
}

}  // namespace ryosen
