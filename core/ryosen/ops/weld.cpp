#include "ryosen/ops/weld.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "ryosen/base/index_set.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/ops/op_series.h"
#include "ryosen/ops/parameters/member_values.h"
#include "ryosen/ops/rules/face_geometry.h"
#include "ryosen/ops/rules/local_facts.h"
#include "ryosen/ops/rules/pinch.h"
#include "ryosen/ops/rules/sheets.h"
#include "ryosen/ops/rules/surgery.h"
#include "ryosen/ops/rules/united_values.h"
#include "ryosen/ops/rules/weld_judge.h"

namespace ryosen {

namespace {

using namespace parameters;

constexpr OpParameter weld_vertices[] = {
    with_words({"first", "First vertex", "最初の頂点", "the vertex whose place they take", "一つになる位置の頂点"},
               required(copy<&Weld::a>("A"))),
    with_words(
        {"second", "Second vertex", "二番目の頂点", "the vertex that is merged into it", "最初の頂点にまとめる頂点"},
        required(copy<&Weld::b>("B"))),
    with_words(
        {"at", "Place", "位置", "where they meet (at the first vertex if it is left out)",
         "一つになる位置（省くと最初の頂点の位置）"},
        optional(named("In the middle", "中央", word<&Weld::place, Weld::Place::middle>("mid")),
                 named("At a position", "座標", position_if<&Weld::target, &Weld::place, Weld::Place::point>())))};
constexpr OpParameter weld_edges[] = {
    with_words(
        {"first", "First edge", "最初の稜線", "the boundary edge whose place they take", "一つになる位置の境界稜線"},
        required(edge<&Weld::first>("A-B"))),
    with_words({"second", "Second edge", "二番目の稜線", "the boundary edge that is merged into it",
                "最初の稜線にまとめる境界稜線"},
               required(edge<&Weld::second>("C-D"))),
    with_words({"at", "In the middle", "中央", "whether they meet in the middle (at the first edge if it is left out)",
                "中央で一つにする（省くと最初の稜線の位置）"},
               optional(word<&Weld::place, Weld::Place::middle>("mid")))};

}  // namespace

constinit const OpInfo Weld::info{
    .id = "weld",
    .name_en = "Weld",
    .name_ja = "縫合",
    .line = {.lists = {weld_vertices, weld_edges}},
    .help_en =
        "merges two vertices, or two boundary edges, at the place of the first, in the middle or anywhere; of what is "
        "selected the vertices into the last, those of faces too",
    .help_ja =
        "二つの頂点、または二本の境界稜線を、最初の位置、中央、または指定の位置で一つにする。選択した頂点（面ではその頂"
        "点）は最後の頂点にまとめる",
    .target = OpTargetKind::selection,
    .group = OpGroup::join,
    .aliases = "merge",
    .on_selection = OnSelection::into_last,
    .in_place_of = &all_their_vertices,
    .along_edge = "collapse",
    .in_series = welds_in_series};

namespace {

// The boundary halfedge, over all sheets, of an edge with one face.
Halfedge boundary_half(const Mesh& m, Halfedge h) {
  for (Halfedge sheet : sheets_between(m, m.from(h), m.to(h)))
    if (m.is_outside(sheet) != m.is_outside(twin(sheet))) return outside_half(m, sheet);
  return Halfedge();
}

// Checks merging two copies of one point into one vertex.
void check_copies(const Mesh& m, Vertex a, Vertex b, Verdict& verdict) {
  for (Vertex v : {a, b})
    if (!m.is_isolated(v) && !m.is_boundary(v)) verdict.refuse(Rule::no_gap, {v, m.face(m.halfedge(v))});
  std::set<Vertex> at_a;
  for (Vertex v : neighbours(m, a)) at_a.insert(v);
  for (Halfedge h : outgoing(m, b))
    if (m.to(h) == a) verdict.refuse(Rule::edge_exists, {edge(h)});
  for (Halfedge h : outgoing(m, b))
    if (at_a.contains(m.to(h)))
      verdict.refuse(Rule::common_neighbour, {point(m, m.to(h)), edge(find_halfedge(m, a, m.to(h))), edge(h)});
}

// Whether an edge joins the two vertices. Cost: twice the lower of their valences.
bool have_edge(const Mesh& m, Vertex v, Vertex w) {
  const auto around_v = outgoing(m, v), around_w = outgoing(m, w);
  auto at_v = around_v.begin(), at_w = around_w.begin();
  for (; at_v != around_v.end() && at_w != around_w.end(); ++at_v, ++at_w)
    if (m.to(*at_v) == w || m.to(*at_w) == v) return true;
  return false;
}

// The one of lower valence first.
std::pair<Vertex, Vertex> by_valence(const Mesh& m, Vertex a, Vertex b) {
  const auto around_a = outgoing(m, a), around_b = outgoing(m, b);
  auto at_a = around_a.begin(), at_b = around_b.begin();
  for (; at_a != around_a.end() && at_b != around_b.end(); ++at_a) ++at_b;
  return at_a == around_a.end() ? std::pair(a, b) : std::pair(b, a);
}

// Whether both have a gap and no common neighbour: whether check_copies() has nothing against them.
bool can_be_one(const Mesh& m, Vertex a, Vertex b) {
  for (Vertex v : {a, b})
    if (m.is_isolated(v) || !m.is_boundary(v)) return false;
  if (have_edge(m, a, b)) return false;
  const auto [few, many] = by_valence(m, a, b);
  const auto to_few = neighbours(m, few);
  return std::none_of(to_few.begin(), to_few.end(), [&, other = many](Vertex v) { return have_edge(m, v, other); });
}

// The pairs of points merged by an edge weld; those of the first edge stay.
WeldPairs pairs_of_edges(const Mesh& m, Halfedge first, Halfedge second) {
  const Halfedge h = boundary_half(m, first), g = boundary_half(m, second);
  WeldPairs pairs;
  for (const auto& [goes, stays] : {std::pair(m.to(g), m.from(h)), std::pair(m.from(g), m.to(h))})
    if (!same_point(m, goes, stays)) pairs.emplace_back(point(m, goes), point(m, stays));
  return pairs;
}

// Whether two edges have sides that may be welded, whatever comes of it.
void check_sides_to_weld(const Mesh& m, Halfedge first, Halfedge second, Verdict& verdict) {
  if (same_point(m, m.from(first), m.from(second)) && same_point(m, m.to(first), m.to(second)))
    return verdict.refuse(Rule::same_edge, {edge(first)});
  if (same_point(m, m.from(first), m.to(second)) && same_point(m, m.to(first), m.from(second)))
    return verdict.refuse(Rule::same_edge, {edge(first)});
  for (Halfedge h : {first, second}) {
    const PointEdge faces = point_edge(m, h);
    if (faces.faces() == 0) verdict.refuse(Rule::wire, {edge(h)});
    if (faces.faces() > 1) verdict.refuse(Rule::has_face, {edge(h), m.face(m.is_outside(h) ? twin(h) : h)});
  }
  if (!verdict.legal()) return;
  const Halfedge h = boundary_half(m, first), g = boundary_half(m, second);
  // If both start, or both end, at their common point, welding them in opposite directions would merge each edge's own
  // ends.
  for (const auto& [x, y] : {std::pair(m.from(h), m.from(g)), std::pair(m.to(h), m.to(g))})
    if (same_point(m, x, y)) return verdict.refuse(Rule::common_face, {m.face(twin(h)), point(m, x)});
}

// The first rule that check_copies() refuses by.
std::optional<Rule> first_rule_of_copies(const Mesh& m, Vertex a, Vertex b) {
  for (Vertex v : {a, b})
    if (!m.is_isolated(v) && !m.is_boundary(v)) return Rule::no_gap;
  if (m.is_isolated(a) || m.is_isolated(b)) return std::nullopt;
  if (have_edge(m, a, b)) return Rule::edge_exists;
  return can_be_one(m, a, b) ? std::nullopt : std::optional(Rule::common_neighbour);
}

// By both points, whether a face has them both, as far as that was asked.
using CommonFaces = std::map<std::pair<Vertex, Vertex>, bool>;

// The first rule that a weld breaks.
std::optional<Rule> first_rule_of(const Mesh& m, const Weld& op, CommonFaces& common) {
  Verdict verdict;
  if (op.first) {
    if (!is_gone(m, op.first, verdict) && !is_gone(m, op.second, verdict))
      check_sides_to_weld(m, op.first, op.second, verdict);
    if (!verdict.legal()) return verdict.reasons[0].rule;
    const WeldPairs pairs = pairs_of_edges(m, op.first, op.second);
    for (const auto& pair : pairs) {
      const auto [has_common, is_new] = common.try_emplace(pair);
      if (is_new) has_common->second = have_common_face(m, pair);
      if (has_common->second) return Rule::common_face;
    }
    return first_rule_of_weld(m, pairs);
  }
  if (is_gone(m, op.a, verdict) || is_gone(m, op.b, verdict)) return Rule::deleted;
  if (op.a == op.b) return Rule::same_vertex;
  if (same_point(m, op.a, op.b)) return first_rule_of_copies(m, op.a, op.b);
  return first_rule_of_weld(m, {{point(m, op.b), point(m, op.a)}});
}

}  // namespace

std::vector<Element> vertices_of_elements(const Mesh& mesh, std::span<const Element> selected) {
  std::vector<Element> vertices;
  IndexSet seen;
  const auto add = [&](Vertex v) {
    if (seen.insert(v.index)) vertices.emplace_back(v);
  };
  for (const Element& e : selected) for_each_vertex(mesh, e, add);
  return vertices;
}

Verdict Weld::check(const Mesh& mesh) const {
  Verdict verdict;
  if (first) {
    if (is_gone(mesh, first, verdict) || is_gone(mesh, second, verdict)) return verdict;
    check_sides_to_weld(mesh, first, second, verdict);
    if (verdict.legal()) judge_weld(mesh, pairs_of_edges(mesh, first, second), verdict);
    return verdict;
  }
  if (is_gone(mesh, a, verdict) || is_gone(mesh, b, verdict)) return verdict;
  if (a == b)
    verdict.refuse(Rule::same_vertex, {a});
  else if (same_point(mesh, a, b))
    check_copies(mesh, a, b, verdict);
  else
    judge_weld(mesh, {{point(mesh, b), point(mesh, a)}}, verdict);
  return verdict;
}

std::vector<Reason> Weld::warnings(const Mesh& mesh) const {
  WeldPairs pairs;
  if (first) pairs = pairs_of_edges(mesh, first, second);
  if (!first && !same_point(mesh, a, b)) pairs = {{point(mesh, b), point(mesh, a)}};
  std::vector<Reason> reasons;
  warn_of_pinch(pinched_by_weld(mesh, pairs), reasons);
  return reasons;
}

namespace {

// From the one that stays to the other.
double along(const Mesh& m, const Weld& op, Vertex goes, Vertex stays) {
  if (op.place == Weld::Place::middle) return 0.5;
  return op.place == Weld::Place::point && !op.first ? closest_parameter(m.position(stays), m.position(goes), op.target)
                                                     : 0;
}

glm::dvec3 place_of(const Mesh& m, const Weld& op, Vertex goes, Vertex stays) {
  if (op.place == Weld::Place::point && !op.first) return op.target;
  return op.place == Weld::Place::middle ? point_between(m.position(stays), m.position(goes), 0.5) : m.position(stays);
}

void move_whole(Edit& edit, Sheets& sheets, Vertex v, const glm::dvec3& to) {
  if (edit.mesh().position(v) == to) return;
  move_point(edit, v, to);
  for_each_copy(edit.mesh(), v, [&](Vertex copy) { sheets.changed_around(copy); });
}

// Makes all vertices of one point copies of the other, with its position and values at `along`, from it on.
void unite_points(Edit& edit, Sheets& sheets, Vertex goes, Vertex stays, double along) {
  const Mesh& m = edit.mesh();
  unite_edges_at(edit, goes, stays);
  move_point(edit, goes, m.position(stays));
  if (unite_ends(edit, goes, stays, 1 - along))
    for_each_copy(m, stays, [&](Vertex copy) {
      if (copy != stays) edit.derive(copy, stays, Derivation::copies);
    });
  for_each_copy(m, goes, [&](Vertex copy) {
    edit.derive(copy, stays, Derivation::copies);
    sheets.changed_around(copy);
  });
  sheets.join_points(goes, stays);
}

// After the two points have become one, which this vertex belongs to.
void know(const Mesh& m, Vertex v, bool has_new_fan, ManifoldPoint& known) {
  const bool is_new = known.at.is_none();
  known.at = v;
  if (is_new) for_each_copy(m, v, [&](Vertex copy) { known.maybe_split.push_back(copy); });
  if (has_new_fan) known.maybe_split.push_back(v);
}

void forget(ManifoldPoint& known) { known = {{}, {}, {}, {}, known.rings, known.looks}; }

// What is looked at where two points become one: all of the one that comes, and what has changed at the other one.
std::vector<Vertex> take_joined(const Mesh& m, Vertex comes, ManifoldPoint& known) {
  std::vector<Vertex> joined = std::exchange(known.changed, {});
  std::erase_if(joined, [&](Vertex v) { return !m.is_alive(v); });
  for_each_copy(m, comes, [&](Vertex copy) { joined.push_back(copy); });
  return joined;
}

}  // namespace

OpEffect Weld::apply(Edit& edit) const {
  ManifoldPoint unknown;
  return apply(edit, unknown);
}

OpEffect Weld::apply(Edit& edit, ManifoldPoint& known) const {
  const Mesh& m = edit.mesh();
  assert(check(m).legal());
  CopyRings own_rings(edit);
  Sheets sheets(edit, known.rings ? *known.rings : own_rings);
  const bool is_one_point = !first && same_point(m, a, b), are_two_points = !first && !is_one_point;
  WeldPairs pairs;
  if (first) pairs = pairs_of_edges(m, first, second);
  if (are_two_points) pairs = {{b, a}};
  bool is_known = !first && known.at && m.is_alive(known.at) && same_point(m, known.at, a) &&
                  (are_two_points || known.changed.empty());
  std::vector<Vertex> joined, touched;
  if (is_known && are_two_points) joined = take_joined(m, b, known);
  for (const auto& [goes, stays] : pairs) {
    const double t = along(m, *this, goes, stays);
    move_whole(edit, sheets, stays, place_of(m, *this, goes, stays));
    unite_points(edit, sheets, goes, stays, t);
  }
  if (is_one_point) {
    move_whole(edit, sheets, a, place_of(m, *this, b, a));
    pairs = {{a, b}};
  }
  for (const auto& [goes, stays] : pairs) {
    for (Vertex v : {goes, stays})
      if (m.is_isolated(v) && has_copies(m, v)) {
        sheets.remove_vertex(v);
        is_known = is_known && !m.is_alive(v) && m.is_alive(known.at);  // else another one has its number
      }
    touched.push_back(std::min(goes, stays));
  }
  if (is_known && are_two_points) {
    std::erase_if(joined, [&](Vertex v) { return !m.is_alive(v); });
    sheets.make_joined_manifold(std::move(joined), known);
  } else if (!is_known) {  // else two copies of a manifold point make one vertex, by which nothing is to be cut or
                           // joined
    sheets.make_manifold(touched);
    forget(known);
  }
  known.looks += sheets.looks();
  const bool are_one = !first && m.is_alive(a) && m.is_alive(b) && can_be_one(m, a, b);
  if (are_one) sheets.join_corner(m.prev(m.halfedge(a)), m.halfedge(b));
  // Where an isolated vertex has come and gone, nothing was looked at.
  const Vertex stays = !first && m.is_alive(a) ? a : b;
  if (!first && m.is_alive(stays) && (is_known || m.is_alive(touched.front()))) know(m, stays, are_one, known);
  return sheets.finish();
}

namespace {

// Knows what has come together at the last point from call to call.
class Welds : public OneByOne {
 public:
  explicit Welds(Edit& edit) : OneByOne(edit), rings_(edit) { known_.rings = &rings_; }
  std::optional<Rule> broken_rule(const AnyOp& op) override {
    const Weld* const weld = std::get_if<Weld>(&op);
    if (!weld) return first_rule_of(std::get<CollapseEdge>(op).check(edit_.mesh(), facts_));
    const Mesh& m = edit_.mesh();
    const bool are_points =
        !weld->first && is_there(m, weld->a) && is_there(m, weld->b) && !same_point(m, weld->a, weld->b);
    if (!are_points) return first_rule_of(m, *weld, common_);
    const auto [rule, is_new] = rules_.try_emplace({point(m, weld->a), point(m, weld->b)});
    if (is_new) rule->second = first_rule_of(m, *weld, common_);
    return rule->second;
  }
  void apply(const AnyOp& op) override {
    rules_.clear();
    common_.clear();
    if (const Weld* const weld = std::get_if<Weld>(&op)) {
      weld->apply(edit_, known_);
      facts_ = {};
    } else {
      collapse(op);
    }
  }

 private:
  // Along the edge between the two.
  void collapse(const AnyOp& op) {
    const Mesh& m = edit_.mesh();
    const Halfedge h = halfedge_of(op);
    const Vertex both[] = {m.from(h), m.to(h)};
    std::vector<Vertex> around;
    for (const Halfedge side : {h, twin(h)})
      if (!m.is_outside(side) && !known_.beside.empty())
        for (const Vertex v : vertices_around(m, m.face(side))) around.push_back(v);
    facts_.collapses(m, h);
    ryosen::apply(edit_, op);
    if (!known_.at) return;
    for (const Vertex v : around)
      if (m.is_alive(v))
        if (const auto beside = known_.beside.find(point(m, v)); beside != known_.beside.end())
          beside->second.push_back(v);
    const bool is_there = m.is_alive(known_.at);
    for (const Vertex v : both)
      if (m.is_alive(v) && is_there && same_point(m, v, known_.at)) return known_.changed.push_back(v);
    forget(known_);
  }

  CopyRings rings_;
  ManifoldPoint known_;
  LocalFacts facts_;  // for collapses
  // By both points, until something is done.
  std::map<std::pair<Vertex, Vertex>, std::optional<Rule>> rules_;
  CommonFaces common_;
};

}  // namespace

std::unique_ptr<OpSeries> welds_in_series(Edit& edit) { return std::make_unique<Welds>(edit); }

}  // namespace ryosen
