#include "core/algo/simplify/simplifier.h"

#include <algorithm>

#include "core/algo/simplify/plain_collapse.h"
#include "core/algo/simplify/small_parts.h"
#include "core/base/parallel.h"
#include "core/mesh/attribute.h"
#include "core/mesh/circulate.h"
#include "core/mesh/copies.h"
#include "core/mesh/prefetch.h"
#include "core/ops/collapse_edge.h"
#include "core/ops/rules/corner_values.h"
#include "core/ops/rules/face_geometry.h"
#include "core/ops/rules/plain_check.h"

namespace ryosen {

namespace {

// Levels from one cost to twice that cost, as a power of two: fewer are faster, more are nearer to the least error.
constexpr std::array<unsigned, 3> level_bits{0, 2, 6};
// How many edges ahead the links and what the ends stand for are asked from memory.
constexpr std::size_t links_ahead = 16, ends_ahead = 8;
constexpr std::size_t edges_between_reports = 1024;

bool has_values(const Mesh& mesh, ElementKind kind) {
  return std::any_of(mesh.attributes().begin(), mesh.attributes().end(),
                     [&](const AttributeColumn& column) { return column.element == kind; });
}

}  // namespace

Simplifier::Simplifier(Mesh& mesh, const CollapseLimits& limits, const SimplifyGoal& goal, Journal* steps)
    : writable_(mesh),
      mesh_(mesh),
      steps_(steps),
      goal_(goal),
      surface_(mesh_, limits),
      queue_(level_bits[goal.effort]),
      is_blocked_(mesh_.edge_slots()),
      has_blocked_(mesh_.vertex_slots()),
      has_corner_values_(!corner_attributes(mesh_).empty()),
      has_vertex_values_(has_values(mesh_, ElementKind::vertex)) {
  if (goal.no_self_intersections) guard_.emplace(mesh_);
  if (!steps) edit_.emplace(mesh, nullptr);
}

void Simplifier::fill_queue() {
  const std::uint32_t slots = mesh_.edge_slots();
  std::vector<LevelQueue::Level> levels(slots);
  for_each_part(slots, threads_for(slots), [&](unsigned, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t i = begin; i < end; ++i)
      if (const Edge e(i); mesh_.is_alive(e) && !mesh_.is_wire(e))
        levels[i] = queue_.level_of(surface_.lowest_cost(halfedge(e)));
  });
  for (std::uint32_t i = 0; i < slots; ++i)
    if (const Edge e(i); mesh_.is_alive(e) && !mesh_.is_wire(e)) queue_.add(i, levels[i]);
}

bool Simplifier::run(Progress& progress) {
  if (is_at_goal()) return progress.go_on();
  fill_queue();
  const std::size_t first_faces = mesh_.live().faces;
  std::size_t before = 0;
  do {
    before = collapses_;
    while (!is_at_goal() && queue_.next()) {
      prefetch(mesh_, halfedge(Edge(queue_.ahead(links_ahead))));
      surface_.prefetch_ends(Edge(queue_.ahead(ends_ahead)));
      const Edge e(queue_.number());
      if (!mesh_.is_alive(e) || mesh_.is_wire(e)) continue;
      if (try_edge(e) == Answer::refused) block(e);
      if (++asked_ % edges_between_reports == 0 &&
          !progress.go_on(first_faces - mesh_.live().faces, first_faces - goal_.faces))
        return false;
    }
  } while (!is_at_goal() && collapses_ > before && find_further());
  if (goal_.removes_small_parts && !is_at_goal()) remove_small_parts();
  return progress.go_on();
}

void Simplifier::remove_small_parts() {
  const double limit = surface_.limits_error() ? surface_.error_limit() : error_max_;
  for (const SmallPart& part : find_small_parts(surface_, limit)) {
    if (is_at_goal()) return;
    if (steps_) edit_.emplace(writable_, steps_);
    remove_part(*edit_, part.vertices);
    if (steps_) edit_->commit();
    ++removed_parts_;
  }
}

bool Simplifier::find_further() {
  bool found = false;
  for (std::uint32_t i = 0; i < mesh_.edge_slots(); ++i) {
    const Edge e(i);
    if (!mesh_.is_alive(e) || mesh_.is_wire(e) || rule_of(e) != EdgeRule::free) continue;
    is_blocked_[i] = 0;
    queue_.add(i, 0);
    found = true;
  }
  return found;
}

bool Simplifier::is_legal(Halfedge h) const {
  const CollapseEdge there{h};
  return there.is_legal(mesh_) || CollapseEdge{twin(h)}.is_legal(mesh_);
}

Simplifier::Answer Simplifier::try_edge(Edge e) {
  const Freedom freedom = surface_.freedom(halfedge(e));
  if (!freedom.is_possible) return Answer::refused;
  const Placing lowest = surface_.lowest(freedom);
  if (const auto level = queue_.level_of(lowest.cost); level > queue_.current()) {
    queue_.add(e.index, level);
    return Answer::later;
  }
  if (!surface_.is_within_error(freedom.halfedge, lowest) || !is_legal(freedom.halfedge)) return Answer::refused;
  if (const Answer answer = try_place(freedom, lowest); answer != Answer::refused || freedom.is_anchored) return answer;
  for (const Placing& other : surface_.others(freedom))
    if (const Answer answer = try_place(freedom, other); answer != Answer::refused) return answer;
  return Answer::refused;
}

Simplifier::Answer Simplifier::try_place(const Freedom& freedom, const Placing& placing) {
  const Halfedge h = freedom.halfedge;
  if (!surface_.is_within_error(h, placing) || surface_.turns_face(h, placing.place) ||
      surface_.narrows_face(h, placing.place))
    return Answer::refused;
  if (const auto level = queue_.level_of(placing.cost); level > queue_.current()) {
    queue_.add(edge(h).index, level);
    return Answer::later;
  }
  if (makes_faces_meet(freedom, placing)) return Answer::refused;
  collapse(freedom, placing);
  return Answer::done;
}

glm::dvec3 Simplifier::position_of(const Placing& placing) const {
  return placing.at ? mesh_.position(placing.at) : surface_.scale().restored(placing.place);
}

bool Simplifier::makes_faces_meet(const Freedom& freedom, const Placing& placing) const {
  return guard_ && guard_->would_meet(freedom.halfedge, position_of(placing));
}

void Simplifier::collapse(const Freedom& freedom, const Placing& placing) {
  Halfedge h = freedom.halfedge;
  error_max_ = std::max(error_max_, surface_.error_of(h, placing));
  const bool is_plain = !has_corner_values_ && quick_collapse(mesh_, h) == QuickAnswer::legal;
  if (!is_plain) {
    if (!CollapseEdge{h}.is_legal(mesh_)) h = twin(h);
    h = CollapseEdge{h}.directed(mesh_);
  }
  const Vertex gone = mesh_.from(h), kept = mesh_.to(h);
  const std::array<Face, 2> sides{mesh_.face(h), mesh_.face(twin(h))};
  if (steps_) edit_.emplace(writable_, steps_);
  write_collapse(h, placing, is_plain);
  if (steps_) {
    edit_->commit();
    edit_.reset();
  }
  surface_.merge(gone, kept, placing.place);
  if (guard_) {
    for (Face f : sides)
      if (f) guard_->forget(f);
    guard_->follow(kept);
  }
  ++collapses_;
  unblock_around(kept);
}

void Simplifier::write_collapse(Halfedge h, const Placing& placing, bool is_plain) {
  const Vertex gone = mesh_.from(h), kept = mesh_.to(h);
  const glm::dvec3 position = position_of(placing);
  if (has_vertex_values_)
    blend_vertex_values(*edit_, gone, kept,
                        closest_parameter(surface_.place(gone), surface_.place(kept), placing.place), kept);
  if (!is_plain) return collapse_by_kernel(h, placing, position);
  plain_collapse(*edit_, h, [&](Edge stays, Edge goes) { surface_.take_over(stays, goes); });
  edit_->set_position(kept, position);
}

void Simplifier::collapse_by_kernel(Halfedge h, const Placing& placing, const glm::dvec3& position) {
  for (Halfedge side : {h, twin(h)}) {
    const Face f = mesh_.face(side);
    if (!f || !is_triangle(mesh_, side) || mesh_.has_rings(f)) continue;
    side == h ? surface_.take_over(edge(mesh_.next(side)), edge(mesh_.prev(side)))
              : surface_.take_over(edge(mesh_.prev(side)), edge(mesh_.next(side)));
  }
  CollapseEdge op{h};
  if (placing.at != mesh_.to(h)) {
    op.place = CollapseEdge::Place::point;
    op.target = position;
  }
  op.apply(*edit_);
}

void Simplifier::block(Edge e) {
  is_blocked_[e.index] = 1;
  for (unsigned side : {0u, 1u}) has_blocked_[mesh_.from(halfedge(e, side)).index] = 1;
}

// What edges around a vertex and around its neighbours ask has changed: their levels are in the past or still to come.
void Simplifier::unblock_around(Vertex v) {
  const auto unblock = [&](Vertex w) {
    if (!has_blocked_[w.index]) return;
    has_blocked_[w.index] = 0;
    for (Halfedge h : outgoing(mesh_, w)) {
      std::uint8_t& is_blocked = is_blocked_[edge(h).index];
      if (!is_blocked) continue;
      is_blocked = 0;
      queue_.add(edge(h).index, queue_.current());
    }
  };
  unblock(v);
  for (Halfedge h : outgoing(mesh_, v)) unblock(mesh_.to(h));
}

std::optional<EdgeRule> Simplifier::refusal(const Freedom& freedom, const Placing& placing) const {
  const Halfedge h = freedom.halfedge;
  if (surface_.turns_face(h, placing.place)) return EdgeRule::normal;
  if (surface_.narrows_face(h, placing.place)) return EdgeRule::angle;
  if (!surface_.is_within_error(h, placing)) return EdgeRule::error;
  if (makes_faces_meet(freedom, placing)) return EdgeRule::self_intersection;
  return std::nullopt;
}

EdgeRule Simplifier::rule_of(Edge e) const {
  const Freedom freedom = surface_.freedom(halfedge(e));
  if (!is_legal(halfedge(e))) return EdgeRule::structure;
  EdgeRule last = EdgeRule::structure;
  const auto add = [&](const Placing& placing) {
    EdgeRule rule = refusal(freedom, placing).value_or(EdgeRule::free);
    const bool is_at_anchor = freedom.is_possible && placing.at == mesh_.to(freedom.halfedge);
    if (freedom.is_anchored && !is_at_anchor) rule = std::min(rule, freedom.held_by);
    last = std::max(last, rule);
  };
  const Freedom unheld{freedom.halfedge};
  add(surface_.lowest(unheld));
  for (const Placing& other : surface_.others(unheld)) add(other);
  return last;
}

}  // namespace ryosen
