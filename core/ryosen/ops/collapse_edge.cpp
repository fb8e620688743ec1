#include "ryosen/ops/collapse_edge.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <glm/geometric.hpp>
#include <optional>
#include <unordered_map>
#include <vector>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/face_polygon.h"
#include "ryosen/mesh/rings.h"
#include "ryosen/ops/op_series.h"
#include "ryosen/ops/parameters/member_values.h"
#include "ryosen/ops/rules/corner_values.h"
#include "ryosen/ops/rules/face_geometry.h"
#include "ryosen/ops/rules/face_lists.h"
#include "ryosen/ops/rules/local_facts.h"
#include "ryosen/ops/rules/united_values.h"

namespace ryosen {

namespace {

using namespace parameters;

constexpr OpParameter collapse_parameters[] = {
    with_words(
        {"edge", "Edge", "稜線", "the edge that is collapsed (A goes, B stays)", "削除する稜線（A が消え、B が残る）"},
        missing(required(edge<&CollapseEdge::halfedge>("A-B")), "an edge A-B is missing",
                "稜線 A-B の指定がありません")),
    with_words(
        {"at", "Place", "位置", "the position of B (B stays if it is left out)", "B の位置（省くと動かない）"},
        expecting(
            optional(named("At the start", "始点", word<&CollapseEdge::place, CollapseEdge::Place::start>("start")),
                     named("At the end", "終点", word<&CollapseEdge::place, CollapseEdge::Place::end>("end")),
                     named("In the middle", "中央", word<&CollapseEdge::place, CollapseEdge::Place::middle>("mid")),
                     named("At a position", "座標",
                           position_if<&CollapseEdge::target, &CollapseEdge::place, CollapseEdge::Place::point>())),
            "start, end, mid or X,Y,Z", "start、end、mid、X,Y,Z のいずれかを"))};

}  // namespace

constinit const OpInfo CollapseEdge::info{
    .id = "collapse",
    .name_en = "Collapse edge",
    .name_ja = "稜線削除",
    .line = {.lists = {collapse_parameters}},
    .help_en = "merges A into B; B keeps its number and, by default, its position",
    .help_ja = "A が消え、B が番号と（指定がなければ）位置を保つ",
    .key = 'C',
    .target = OpTargetKind::edge,
    .group = OpGroup::join,
    .topology = Topology::kept,
    .in_series = collapses_in_series};

namespace {

constexpr std::size_t usual_valence = 12;  // for reserving lists

// How far the place lies from the end that goes (0) to the one that stays (1). `h` leads from the first to the other,
// against the halfedge of the operator where its first end has to stay.
double along(const Mesh& m, const CollapseEdge& op, Halfedge h) {
  const bool is_turned = h != op.halfedge;
  switch (op.place) {
    case CollapseEdge::Place::automatic:
      return 1;
    case CollapseEdge::Place::start:
      return is_turned ? 1 : 0;
    case CollapseEdge::Place::end:
      return is_turned ? 0 : 1;
    case CollapseEdge::Place::middle:
      return 0.5;
    case CollapseEdge::Place::point:
      break;
  }
  return closest_parameter(m.position(m.from(h)), m.position(m.to(h)), op.target);
}

// The edges that take the place of others where triangles go.
std::vector<Edge> staying_edges(const Mesh& mesh, Halfedge h) {
  std::vector<Edge> edges;
  if (!has_attributes(mesh, ElementKind::edge)) return edges;
  if (is_triangle_side(mesh, h)) edges.push_back(edge(mesh.next(h)));
  if (is_triangle_side(mesh, twin(h))) edges.push_back(edge(mesh.prev(twin(h))));
  return edges;
}

// Removes a triangle that has become a face with two sides: `going` starts or ends at the removed vertex, `staying` is
// the other side. `staying` replaces the twin of `going` in the adjacent face or boundary loop.
void close_two_gon(Edit& edit, Halfedge going, Halfedge staying, OpEffect& effect) {
  const Mesh& m = edit.mesh();
  const Halfedge beyond = twin(going);
  const Face dropped = m.face(staying), face = m.face(beyond);
  const Vertex apex = m.from(going) == m.to(staying) ? m.from(going) : m.to(going);
  const Halfedge from_apex = m.from(going) == apex ? going : beyond;
  const Edge both[] = {edge(staying), edge(going)};
  constexpr double half_each[] = {0.5, 0.5};
  edit.derive<Edge>(both[0], both, half_each, Derivation::unites);
  edit.derive(staying, beyond, Derivation::copies);
  edit.connect(m.prev(beyond), staying);
  edit.connect(staying, m.next(beyond));
  edit.set_face(staying, face);
  if (face) replace_start(edit, face, beyond, staying);
  if (m.halfedge(apex) == from_apex) edit.set_halfedge(apex, m.from(staying) == apex ? staying : twin(staying));
  edit.remove(edge(going));
  edit.drop(dropped);
  effect.deleted.push_back(edge(going));
  effect.deleted.push_back(dropped);
}

// Deletes the edge of h and the triangles at it, so that both ends have one cycle. Gives a halfedge of it: the first
// after h, or beyond a free end of a wire. Which vertex the halfedges leave, and which one that vertex stores, is for
// the caller.
Halfedge take_edge_out(Edit& edit, Halfedge h, OpEffect& effect) {
  const Mesh& m = edit.mesh();
  const Halfedge o = twin(h);
  const bool left_two_gon = is_triangle_side(m, h), right_two_gon = is_triangle_side(m, o);
  const Halfedge h_next = m.next(h), h_prev = m.prev(h), o_next = m.next(o), o_prev = m.prev(o);
  // A wire may have a free end, where its halves follow each other.
  const bool tip_kept = h_next == o, tip_gone = o_next == h;
  for (Halfedge side : {h, o}) {
    const Face f = m.face(side);
    if (f) replace_start(edit, f, side, m.next(side));
  }
  if (!tip_kept && !tip_gone) {
    edit.connect(h_prev, h_next);
    edit.connect(o_prev, o_next);
  } else {
    edit.connect(tip_kept ? h_prev : o_prev, tip_kept ? o_next : h_next);
  }
  if (left_two_gon) close_two_gon(edit, h_prev, h_next, effect);
  if (right_two_gon) close_two_gon(edit, o_next, o_prev, effect);
  edit.drop(edge(h));
  return tip_kept ? o_next : h_next;
}

}  // namespace

CollapseEdge CollapseEdge::at(const Mesh&, const OpTarget& target) {
  // The end nearer to the pointer is a; over the third at that end the other one comes to it.
  const bool is_at_start = target.along <= 0.5;
  const double from_end = is_at_start ? target.along : 1 - target.along;
  if (!target.is_small && from_end < 1.0 / 3)
    return {is_at_start ? twin(target.halfedge) : target.halfedge, Place::automatic};
  return {is_at_start ? target.halfedge : twin(target.halfedge), Place::middle};
}

glm::dvec3 CollapseEdge::position(const Mesh& mesh) const {
  const glm::dvec3 &a = mesh.position(mesh.from(halfedge)), &b = mesh.position(mesh.to(halfedge));
  switch (place) {
    case Place::automatic:
      return mesh.position(mesh.to(directed(mesh)));
    case Place::start:
      return a;
    case Place::end:
      return b;
    case Place::middle:
      return point_between(a, b, 0.5);
    case Place::point:
      break;
  }
  return target;
}

std::vector<Reason> CollapseEdge::warnings(const Mesh& mesh) const {
  const Halfedge h = directed(mesh);
  const glm::dvec3 place_after = position(mesh);
  std::vector<Reason> found;
  if (is_seam(mesh, h)) found.push_back({Rule::seam, {edge(h)}});
  const Vertex gone = mesh.from(h), kept = mesh.to(h);
  ShapeDoubts shape;
  FacePolygon polygon;
  const auto look = [&](Face f) {
    const bool is_at_edge = f == mesh.face(h) || f == mesh.face(twin(h));
    if (is_at_edge && corner_count(mesh, f) == 3) return;  // vanishes
    polygon.read(mesh, f);
    const FaceGeometry before(polygon.keyhole_walk());
    polygon.move(mesh, gone, place_after);
    polygon.move(mesh, kept, place_after);
    shape.compare(before, FaceGeometry(polygon.keyhole_walk()), f);
  };
  for (Halfedge g : outgoing(mesh, gone))
    if (!mesh.is_outside(g)) look(mesh.face(g));
  for_each_copy(mesh, kept, [&](Vertex copy) {
    for (Halfedge k : outgoing(mesh, copy))
      if (!mesh.is_outside(k) && mesh.face(k) != mesh.face(h) && mesh.face(k) != mesh.face(twin(h))) look(mesh.face(k));
  });
  shape.add_to(found);
  return found;
}

OpEffect CollapseEdge::apply(Edit& edit) const {
  const Mesh& m = edit.mesh();
  assert(check(m).legal());
  const Halfedge h = directed(m), o = twin(h);
  const Vertex gone = m.from(h), kept = m.to(h);
  OpEffect effect;
  effect.deleted.reserve(6);
  effect.deleted.push_back(gone);
  effect.deleted.push_back(edge(h));
  std::optional<glm::dvec3> moved;
  if (place != Place::automatic) moved = position(m);
  merge_ends(edit, h, along(m, *this, h), gone, kept);
  const std::vector<Edge> staying = staying_edges(m, h);
  Halfedge hold = m.halfedge(kept);
  const Halfedge some = take_edge_out(edit, h, effect);
  if (hold == o) hold = some;
  // The remaining vertex must store a boundary halfedge, if it has one.
  effect.changed.reserve(usual_valence);
  Halfedge g = some;
  do {
    if (m.from(g) != kept) edit.set_from(g, kept);
    if (m.is_outside(g))
      hold = g;
    else
      effect.changed.push_back(m.face(g));
    g = m.counter_clockwise(g);
  } while (g != some);
  edit.set_halfedge(kept, hold);
  edit.remove(gone);
  share_among_sheets(edit, staying);
  if (!moved) return effect;
  move_point(edit, kept, *moved);
  for_each_copy(m, kept, [&](Vertex copy) {
    if (copy == kept) return;
    for (Halfedge around : outgoing(m, copy))
      if (!m.is_outside(around)) effect.changed.push_back(m.face(around));
  });
  return effect;
}

namespace {

// Many edges collapsed one after another: the same mesh as by one call each, at the cost of the smaller end of each
// edge.
//
// By itself a call looks at both ends and renames the halfedges of the one that goes, which is quadratic where one
// vertex meets all others. Here the smaller of two ends takes over the slot of the larger, and the number that the
// vertex goes by is kept beside it until the end. n edges cost n log n looks at halfedges.
class CollapseSeries : public OneByOne {
 public:
  explicit CollapseSeries(Edit& edit) : OneByOne(edit) {}

  std::optional<Rule> broken_rule(const AnyOp& op) override {
    return std::get<CollapseEdge>(op).broken_rule(mesh(), known_);
  }
  void apply(const AnyOp& any) override {
    const CollapseEdge& op = std::get<CollapseEdge>(any);
    const Mesh& m = mesh();
    const Halfedge h = op.directed(m, known_);
    const Vertex gone = m.from(h), kept = m.to(h);
    std::optional<glm::dvec3> moved;
    if (op.place != CollapseEdge::Place::automatic) moved = op.position(m);
    merge_ends(edit_, h, along(m, op, h), number(gone), number(kept));
    known_.collapses(m, h);
    join(h, moved);
  }
  Vertex number(Vertex slot) const override {
    const auto found = numbers_.find(slot);
    return found == numbers_.end() ? slot : found->second;
  }
  // Gives the vertices their numbers. Until then the mesh has others.
  void finish() override {
    for (const auto& [slot, stays] : numbers_) {
      if (slot == stays) continue;
      for (const Halfedge g : outgoing(mesh(), slot)) edit_.set_from(g, stays);
      edit_.set_halfedge(stays, mesh().halfedge(slot));
      edit_.set_position(stays, mesh().position(slot));
      edit_.remove(slot);
    }
    known_ = {};
    numbers_.clear();
    gaps_.clear();
  }

 private:
  const Mesh& mesh() const { return edit_.mesh(); }
  std::uint32_t gaps(Vertex v) {
    const auto [count, is_new] = gaps_.try_emplace(v, 0);
    if (!is_new) return count->second;
    for (const Halfedge g : outgoing(mesh(), v)) count->second += mesh().is_outside(g);
    return count->second;
  }
  bool kept_is_smaller(Halfedge h) const {
    for (Halfedge g = h, k = twin(h);;) {
      g = mesh().counter_clockwise(g);
      k = mesh().counter_clockwise(k);
      if (g == h) return false;
      if (k == twin(h)) return true;
    }
  }
  // The gap where the two ends have one between them, as it will be when the edge and the triangles at it are gone.
  Halfedge only_gap_left(Halfedge h) const {
    const Mesh& m = mesh();
    const Halfedge at_kept = m.halfedge(m.to(h)), at_gone = m.halfedge(m.from(h));
    if (at_kept != twin(h) && m.is_outside(at_kept)) return at_kept;
    // A side that vanishes with its triangle hands its gap to the other one.
    return !m.is_outside(h) && is_triangle(m, h) && at_gone == twin(m.prev(h)) ? m.next(h) : at_gone;
  }
  // As the call by itself has it, which goes around counter-clockwise and takes the last.
  Halfedge first_gap_clockwise(Halfedge from) const {
    for (Halfedge g = mesh().clockwise(from); g != from; g = mesh().clockwise(g))
      if (mesh().is_outside(g)) return g;
    return from;
  }
  void join(Halfedge h, std::optional<glm::dvec3> moved) {
    const Mesh& m = mesh();
    const Halfedge o = twin(h);
    const Vertex gone = m.from(h), kept = m.to(h);
    const std::uint32_t gaps_left = gaps(gone) + gaps(kept) - m.is_outside(h) - m.is_outside(o);
    Halfedge hold;
    if (gaps_left == 0 && m.halfedge(kept) != o) hold = m.halfedge(kept);
    if (gaps_left == 1 && !m.is_wire(edge(h))) hold = only_gap_left(h);
    const bool moves_in = !known_.has_several_fans(m, kept) && kept_is_smaller(h);
    const Vertex slot = moves_in ? gone : kept, other = moves_in ? kept : gone;
    std::vector<Halfedge> renamed;
    for (const Halfedge g : outgoing(m, other)) renamed.push_back(g);

    const std::vector<Edge> staying = staying_edges(m, h);
    OpEffect unheard;
    const Halfedge some = take_edge_out(edit_, h, unheard);
    for (const Halfedge g : renamed)
      if (m.is_alive(g)) edit_.set_from(g, slot);
    if (!hold) hold = gaps_left == 0 ? some : first_gap_clockwise(some);
    edit_.set_halfedge(slot, hold);
    share_among_sheets(edit_, staying);
    move_point(edit_, slot, moved ? *moved : m.position(kept));
    give_number(slot, other, number(kept));
    gaps_.erase(other);
    gaps_[slot] = gaps_left;
  }
  void give_number(Vertex slot, Vertex other, Vertex stays) {
    for (const Vertex v : {other, number(slot), number(other)})
      if (v != slot && v != stays && mesh().is_alive(v)) edit_.remove(v);
    numbers_.erase(other);
    numbers_[slot] = stays;
  }

  LocalFacts known_;
  std::unordered_map<Vertex, Vertex> numbers_;      // by slot, where it is another
  std::unordered_map<Vertex, std::uint32_t> gaps_;  // outside halfedges that leave it, by slot
};

}  // namespace

std::unique_ptr<OpSeries> collapses_in_series(Edit& edit) { return std::make_unique<CollapseSeries>(edit); }

}  // namespace ryosen
