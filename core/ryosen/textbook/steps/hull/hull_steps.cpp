#include "ryosen/textbook/steps/hull/hull_steps.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <set>

#include "ryosen/base/count_text.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/textbook/steps/hull/step_builder.h"

namespace ryosen {

using forms::DcelRecords;

std::string_view id_of(DcelChange::Table table) {
  constexpr std::array<std::string_view, 3> ids{"vertex", "half_edge", "face"};
  return ids[static_cast<std::size_t>(table)];
}

std::string_view id_of(DcelChange::Field field) {
  constexpr std::array<std::string_view, 7> ids{"incident_edge", "origin", "twin",           "next",
                                                "prev",          "face",   "outer_component"};
  return ids[static_cast<std::size_t>(field)];
}

std::uint32_t& cell(DcelRecords& records, const DcelChange& change) {
  const auto row_of = [&](auto& table) -> auto& {
    if (change.row >= table.size()) table.resize(change.row + std::size_t{1});
    return table[change.row];
  };
  if (change.table == DcelChange::Table::vertex) return records.vertices[change.row].incident_edge;
  if (change.table == DcelChange::Table::face) return row_of(records.faces).outer_component;
  DcelRecords::HalfEdgeRecord& h = row_of(records.half_edges);
  switch (change.field) {
    case DcelChange::Field::origin:
      return h.origin;
    case DcelChange::Field::twin:
      return h.twin;
    case DcelChange::Field::next:
      return h.next;
    case DcelChange::Field::prev:
      return h.prev;
    default:
      return h.face;
  }
}

void apply(const HullStep& step, DcelRecords& records) {
  for (const DcelChange& change : step.changes) cell(records, change) = change.new_value;
}

void take_back(const HullStep& step, DcelRecords& records) {
  for (auto change = step.changes.rbegin(); change != step.changes.rend(); ++change)
    cell(records, *change) = change->old_value;
  records.half_edges.resize(step.half_edge_rows);
  records.faces.resize(step.face_rows);
}

namespace {

Text text_of_begin(const HullStep& step) {
  if (step.is_planar)
    return {"Three points that are not on a line make the first triangle.",
            "一直線上にない 3 点で最初の三角形を作ります。"};
  return {"Four points that span space make the first four faces.", "空間を張る 4 点で最初の 4 面を作ります。"};
}

// Why the point changes nothing.
Text text_of_rest(const HullStep& step, const std::string& witness) {
  const std::string p = std::to_string(step.point);
  if (step.kind == HullStep::Kind::equal)
    return {"Point " + p + " lies at the place of vertex " + witness + ": it changes nothing.",
            "点 " + p + " は頂点 " + witness + " と同じ位置にあるため、何も変わりません。"};
  const bool is_inside = step.kind == HullStep::Kind::inside;
  if (step.is_planar)
    return is_inside
               ? Text{"Point " + p + " sees no edge: it lies inside and changes nothing.",
                      "点 " + p + " からはどの稜線も見えません。内部にあるため何も変わりません。"}
               : Text{"Point " + p + " sees no edge and lies on the line of edge " + witness + ": it changes nothing.",
                      "点 " + p + " からはどの稜線も見えず、稜線 " + witness +
                          " の直線上にあるため、何も変わりません。"};
  return is_inside
             ? Text{"Point " + p + " sees no face: it lies inside and changes nothing.",
                    "点 " + p + " からはどの面も見えません。内部にあるため何も変わりません。"}
             : Text{"Point " + p + " sees no face and lies in the plane of face " + witness + ": it changes nothing.",
                    "点 " + p + " からはどの面も見えず、面 " + witness + " の平面上にあるため、何も変わりません。"};
}

// How many of the made elements go with another one.
std::size_t count_united(const HullStep& step) {
  std::set<std::uint32_t> united;
  for (const auto& [one, other] : step.united) united.insert({one, other});
  return static_cast<std::size_t>(
      std::count_if(step.made.begin(), step.made.end(), [&](std::uint32_t made) { return united.contains(made); }));
}

Text text_of_extending(const HullStep& step) {
  const std::string p = std::to_string(step.point), seen = std::to_string(step.seen.size()),
                    horizon = std::to_string(step.horizon.size());
  const bool is_one = step.seen.size() == 1;
  Text text;
  if (step.is_planar) {
    text = {"Point " + p + " sees " + seen + (is_one ? " edge: it goes" : " edges: they go") +
                ", and each end of this chain is joined to it by an edge.",
            "点 " + p + " から稜線 " + seen + " 本が見えます。それらを削除し、その両端を点と稜線で結びます。"};
    if (!step.united.empty())
      text += count_text(count_united(step),
                         " One of these lies on the line of the edge beside it, and is one edge with it.",
                         " # of these lie on the line of the edge beside them, and are one edge with it.",
                         "うち # 本は隣の稜線と一直線上にあり、一本の稜線にまとまります。");
    return text;
  }
  text = {"Point " + p + " sees " + seen + (is_one ? " face: it goes" : " faces: they go") + ", and each of the " +
              horizon + " edges of the horizon makes a face with it.",
          "点 " + p + " から面 " + seen + " 枚が見えます。それらを削除し、ホライゾンの稜線 " + horizon +
              " 本のそれぞれと点を結んで新しい面を作ります。"};
  if (!step.united.empty())
    text += count_text(count_united(step), " One of them lies in the plane of its neighbour, and is one facet with it.",
                       " # of them lie in the plane of their neighbour, and are one facet with it.",
                       "うち # 枚は隣の面と同一平面上にあり、一枚の面にまとまります。");
  return text;
}

}  // namespace

Text caption(const HullStep& step, const std::string& witness) {
  if (step.kind == HullStep::Kind::begin) return text_of_begin(step);
  return step.kind == HullStep::Kind::extend
             ? text_of_extending(step)
             : text_of_rest(step, witness.empty() ? std::to_string(step.witness) : witness);
}

HullSteps::HullSteps(std::span<const glm::dvec3> points, HullOrder order, std::uint64_t seed) : points_(points) {
  const auto count = static_cast<std::uint32_t>(points.size());
  std::vector<std::uint32_t> numbers;
  if (order == HullOrder::random) {
    numbers = shuffled_numbers(count, seed);
  } else {
    numbers.resize(count);
    std::iota(numbers.begin(), numbers.end(), 0u);
  }
  std::erase_if(numbers, [&](std::uint32_t i) { return !is_finite(points[i]); });
  const hull::FirstPoints first = hull::first_points(points, numbers);
  dimension_ = first.dimension;
  if (dimension_ == 2)
    builder_ = hull::planar_steps(points, order, std::move(numbers), first);
  else if (dimension_ == 3)
    builder_ = hull::solid_steps(points, order, std::move(numbers), first);
}

HullSteps::~HullSteps() = default;
HullSteps::HullSteps(HullSteps&&) noexcept = default;
HullSteps& HullSteps::operator=(HullSteps&&) noexcept = default;

HullSteps HullSteps::copy() const {
  HullSteps other;
  other.points_ = points_;
  other.dimension_ = dimension_;
  if (builder_) other.builder_ = builder_->copy();
  return other;
}

int HullSteps::dimension() const { return dimension_; }
std::size_t HullSteps::step_count() const { return builder_ ? builder_->step_count() : 0; }
std::size_t HullSteps::steps_done() const { return builder_ ? builder_->steps_done() : 0; }
const HullStep* HullSteps::next(bool tells_why) { return builder_ ? builder_->next(tells_why) : nullptr; }
std::size_t HullSteps::made_so_far() const { return builder_ ? builder_->made_so_far() : 0; }
ConvexHull HullSteps::hull() const { return builder_ ? builder_->hull() : convex_hull(points_); }

const forms::DcelRecords& HullSteps::records() const {
  static const forms::DcelRecords none;
  return builder_ ? builder_->records() : none;
}

}  // namespace ryosen
