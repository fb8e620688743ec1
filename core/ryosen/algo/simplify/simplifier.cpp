#include "ryosen/algo/simplify/simplifier.h"

#include <algorithm>
#include <utility>

#include "ryosen/algo/features.h"
#include "ryosen/algo/simplify/plain_collapse.h"
#include "ryosen/algo/simplify/ring_values.h"
#include "ryosen/base/parallel.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/mesh/rings.h"
#include "ryosen/ops/collapse_edge.h"
#include "ryosen/ops/rules/face_geometry.h"
#include "ryosen/ops/rules/plain_check.h"
#include "ryosen/ops/rules/united_values.h"

namespace ryosen {

namespace {

// Levels from one cost to twice that cost, as a power of two: fewer are faster, more are nearer to the least error.
constexpr std::array<unsigned, 3> level_bits{1, 1, 6};

// Without copies, wires and rings.
bool has_only_triangles(const Mesh& mesh) {
  if (mesh.has_copies() || mesh.has_rings()) return false;
  for (const Face f : live_faces(mesh))
    if (!is_triangle(mesh, mesh.halfedge(f))) return false;
  for (const Edge e : live_edges(mesh))
    if (mesh.is_wire(e)) return false;
  return true;
}

// Scaled.
double diagonal_of(const CollapseSurface& surface) {
  Box box;
  for (const Vertex v : live_vertices(surface.mesh()))
    if (!surface.mesh().is_isolated(v) && is_finite(surface.place(v))) box.add(surface.place(v));
  return box.is_empty() ? 0 : glm::length(box.highest - box.lowest);
}

}  // namespace

Simplifier::Simplifier(Mesh& mesh, const CollapseLimits& limits, const SimplifyGoal& goal, Journal* steps,
                       const Mesh* input, Descent* descent)
    : writable_(mesh),
      mesh_(mesh),
      steps_(steps),
      goal_(goal),
      surface_(mesh_, limits),
      queue_(level_bits[goal.effort]),
      input_(input),
      is_blocked_(mesh_.edge_slots()),
      has_blocked_(mesh_.vertex_slots()),
      has_corner_values_(has_attributes(mesh_, ElementKind::corner)),
      has_vertex_values_(has_attributes(mesh_, ElementKind::vertex)),
      has_triangles_alone_(has_only_triangles(mesh_)) {
  if (goal.no_self_intersections) crossing_guard_.emplace(mesh_);
  if (crossing_guard_ && goal.has_self_intersections) crossing_guard_->inherit();
  if (goal.keeps_shape) jump_.emplace(diagonal_of(surface_), mesh_.live().faces);
  if (goal.most_distance < std::numeric_limits<double>::infinity()) {
    distance_guard_.emplace(mesh_, surface_.scale(), goal.most_distance);
    goal_.removes_small_parts = false;
  }
  if (!steps) edit_.emplace(mesh, nullptr, descent);
  if (input_ && !steps && !crossing_guard_ && goal.effort > 0) merged_into_.resize(mesh_.vertex_slots());
}

void Simplifier::fill_queue() {
  const std::uint32_t slots = mesh_.edge_slots();
  std::vector<LevelQueue::Level> levels(slots);
  for_each_part(slots, threads_for(slots), [&](unsigned, std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t i = begin; i < end; ++i)
      if (const Edge e(i); mesh_.is_alive(e) && !mesh_.is_wire(e))
        levels[i] = queue_.level_of(surface_.lowest_cost(halfedge(e)));
  });
  for (const Edge e : live_edges(mesh_))
    if (!mesh_.is_wire(e)) queue_.add(e.index, levels[e.index]);
}

bool Simplifier::run(Progress& progress) {
  if (is_at_goal()) return progress.go_on();
  fill_queue();
  if (!collapse_all(progress)) return false;
  if (goal_.changes_topology && !is_at_goal() && !change_topology(progress)) return false;
  if (is_at_goal()) queue_.clear();
  if (!merged_into_.empty() && collapses_ > 0 && !come_nearer(progress)) return false;
  const bool may_mend = !merged_into_.empty() && has_triangles_alone_ && !has_corner_values_;
  if (may_mend && is_at_goal() && !mend_turned(progress)) return false;
  if (goal_.removes_small_parts && !is_at_goal()) remove_small_parts();
  return progress.go_on();
}

bool Simplifier::collapse_all(Progress& progress) {
  const std::size_t first_faces = mesh_.live().faces;
  std::size_t before = 0;
  do {
    before = collapses_;
    while (!is_at_goal() && take_batch()) {
      warm_rings();
      for (std::size_t i = 0; i < batch_.size() && !is_at_goal(); ++i)
        if (try_again(batch_[i]) == Answer::refused) block(batch_[i].edge);
      if (goal_.removes_small_parts) remove_noted_parts();
      if (!progress.go_on(first_faces - mesh_.live().faces, first_faces - goal_.faces)) return false;
    }
  } while (!is_at_goal() && ((minds_less(collapses_ > before) && find_further(progress)) ||
                             (lets_boundaries_go() && find_further(progress))));
  return !progress.is_cancelled();
}

// Whether there is more to try where nothing collapses any more; as long as lines are minded, once more while something
// did.
bool Simplifier::minds_less(bool has_collapsed) {
  using Minds = CollapseSurface::Minds;
  if (minds_ == Minds::nothing) return has_collapsed;
  minds_ = minds_ == Minds::input || has_collapsed ? Minds::lines : Minds::nothing;
  return true;
}

// Whether it does so now; then lines are minded again.
bool Simplifier::lets_boundaries_go() {
  if (!goal_.lets_boundaries_go || !surface_.keeps_boundaries()) return false;
  surface_.keep_boundaries(false);
  minds_ = CollapseSurface::Minds::lines;
  return true;
}

bool Simplifier::has_edges_held_by_boundaries(Progress& progress) {
  if (!surface_.keeps_boundaries()) return false;
  surface_.keep_boundaries(false);
  bool has_free = false;
  {
    const CollapseSurface::Standstill still(surface_);
    for (std::uint32_t i = 0; i < mesh_.edge_slots() && !has_free && (i % 256 > 0 || progress.go_on()); ++i)
      has_free = can_collapse(Edge(i));
  }
  surface_.keep_boundaries(true);
  return has_free;
}

bool Simplifier::find_further(Progress& progress) {
  bool found = false;
  const CollapseSurface::Standstill still(surface_);
  for (std::uint32_t i = 0; i < mesh_.edge_slots(); ++i) {
    if (i % 256 == 0 && !progress.go_on()) return false;
    if (!can_collapse(Edge(i))) continue;
    is_blocked_[i] = 0;
    queue_.add(i, 0);
    found = true;
  }
  return found;
}

Simplifier::Legality Simplifier::legality(Halfedge h) const {
  const QuickAnswer quick = quick_collapse(mesh_, h);
  if (quick != QuickAnswer::unknown) return quick == QuickAnswer::legal ? Legality::plain : Legality::none;
  const bool is_at_hub = is_plain_at_hub(h);
  if (is_at_hub) {
    const QuickAnswer at_hub = collapse_at_hub(h);
    if (at_hub != QuickAnswer::unknown) return at_hub == QuickAnswer::legal ? Legality::at_hub : Legality::none;
  }
  if (!kernel_allows(h) && !kernel_allows(twin(h))) return Legality::none;
  return is_at_hub ? Legality::at_hub : Legality::by_kernel;
}

bool Simplifier::kernel_allows(Halfedge h) const { return CollapseEdge{h}.judge(mesh_, known_).legal(); }

// One of a batch, after others of it have collapsed.
Simplifier::Answer Simplifier::try_again(const Candidate& candidate) {
  const Edge e = candidate.edge;
  if (!mesh_.is_alive(e) || mesh_.is_wire(e)) return Answer::later;
  if (surface_.history(candidate.freedom.halfedge) == candidate.history)
    return try_edge(candidate.freedom, candidate.lowest);
  const Freedom freedom = surface_.freedom(halfedge(e));
  if (!freedom.is_possible) return Answer::refused;
  const Placing lowest = surface_.lowest(freedom);
  if (const auto level = queue_.level_of(lowest.cost); level > queue_.current()) {
    queue_.add(e.index, level);
    return Answer::later;
  }
  return try_edge(freedom, lowest);
}

Simplifier::Answer Simplifier::try_edge(const Freedom& freedom, const Placing& lowest) {
  const Halfedge h = freedom.halfedge;
  const auto is_near = [&](const Placing& placing) { return is_within_error(h, placing); };
  std::optional<std::array<Placing, 3>> others;
  if (!is_near(lowest)) {
    if (freedom.is_anchored) return Answer::refused;
    others = surface_.others(freedom);  // an end may be exact where the lowest place is so within rounding
    if (std::none_of(others->begin(), others->end(), is_near)) return Answer::refused;
  }
  const Legality legality = this->legality(freedom.halfedge);
  if (legality == Legality::none) {
    if (goal_.removes_small_parts) note_small_part(h);
    return Answer::refused;
  }
  // Either guard compares all faces that move with each other: first without moving those of a hub.
  if ((crossing_guard_ || distance_guard_) && !freedom.is_anchored)
    for (Halfedge end : {h, twin(h)})
      if (const Vertex hub = mesh_.from(end); is_hub(hub)) {
        const Placing there = surface_.at_place(freedom, surface_.place(hub), hub);
        if (const Answer answer = try_place(freedom, there, legality); answer != Answer::refused) return answer;
      }
  if (const Answer answer = try_place(freedom, lowest, legality); answer != Answer::refused || freedom.is_anchored)
    return answer;
  if (!others) others = surface_.others(freedom);
  for (const Placing& other : *others)
    if (const Answer answer = try_place(freedom, other, legality); answer != Answer::refused) return answer;
  return Answer::refused;
}

Simplifier::Answer Simplifier::try_place(const Freedom& freedom, const Placing& placing, Legality legality) {
  const Halfedge h = freedom.halfedge;
  if (!is_within_error(h, placing) ||
      (distance_guard_ && distance_guard_->moves_hub(h, surface_.position_of(placing))) ||
      surface_.turns_face(h, placing, minds_) || surface_.narrows_face(h, placing.place))
    return Answer::refused;
  const auto waits = [&](double cost) {
    const auto level = queue_.level_of(cost);
    if (level > queue_.current()) queue_.add(edge(h).index, level);
    return level > queue_.current();
  };
  if (waits(placing.cost) || waits(surface_.cost_of_gap(h, placing))) return Answer::later;
  if (makes_faces_meet(freedom, placing) || may_exceed_distance(freedom, placing)) return Answer::refused;
  const bool is_plain = legality != Legality::by_kernel && !has_corner_values_;
  collapse(freedom, placing, is_plain ? legality : Legality::by_kernel);
  return Answer::done;
}

bool Simplifier::is_within_error(Halfedge h, const Placing& placing) const {
  const double limit = surface_.error_limit();
  return surface_.error_of(h, placing) <= (jump_ ? std::min(limit, jump_->limit()) : limit);
}

bool Simplifier::makes_faces_meet(const Freedom& freedom, const Placing& placing) const {
  return crossing_guard_ && crossing_guard_->would_meet(freedom.halfedge, surface_.position_of(placing));
}

bool Simplifier::may_exceed_distance(const Freedom& freedom, const Placing& placing) const {
  return distance_guard_ && distance_guard_->collapse_may_exceed(freedom.halfedge, surface_.position_of(placing));
}

// From the vertex that goes to the one that stays.
Halfedge Simplifier::directed(const Freedom& freedom, Legality legality) {
  Halfedge h = freedom.halfedge;
  // What goes is walked around.
  if (legality == Legality::at_hub && !freedom.is_anchored && is_hub(mesh_.from(h))) return twin(h);
  if (legality != Legality::by_kernel) return h;
  if (!kernel_allows(h)) h = twin(h);
  return known_.has_several_fans(mesh_, mesh_.from(h)) ? twin(h) : h;
}

void Simplifier::collapse(const Freedom& freedom, const Placing& placing, Legality legality) {
  const Halfedge h = directed(freedom, legality);
  error_max_ = std::max(error_max_, surface_.error_of(h, placing));
  const Vertex gone = mesh_.from(h), kept = mesh_.to(h);
  const std::array<Face, 2> sides{mesh_.face(h), mesh_.face(twin(h))};
  const std::array<Vertex, 2> apexes{mesh_.from(mesh_.prev(h)), mesh_.from(mesh_.prev(twin(h)))};
  if (legality == Legality::by_kernel)
    for (Face f : sides)
      if (f && !known_.is_one_simple_loop(mesh_, f)) known_.forget(f);
  surface_.follow_large_faces(h, placing);
  if (steps_) edit_.emplace(writable_, steps_);
  write_collapse(h, placing, legality != Legality::by_kernel);
  if (steps_) {
    edit_->commit();
    edit_.reset();
  }
  surface_.merge(gone, kept, mesh_.position(kept));
  if (crossing_guard_) {
    for (Face f : sides)
      if (f) crossing_guard_->forget(f);
    crossing_guard_->follow(kept);
  }
  if (distance_guard_) distance_guard_->follow();
  ++collapses_;
  if (jump_) jump_->follow(mesh_.live().faces, error_max_);
  unblock_around(kept, apexes);
}

void Simplifier::write_collapse(Halfedge h, const Placing& placing, bool is_plain) {
  const Vertex gone = mesh_.from(h), kept = mesh_.to(h);
  const glm::dvec3 position = surface_.position_of(placing);
  AttributeError* const values = surface_.values();
  const AttributeError::Charts charts = values ? values->charts_around(h) : AttributeError::Charts();
  carry_values(h, placing);
  if (values) values->follow(charts, h);
  if (!merged_into_.empty()) merged_into_[gone.index] = kept;
  if (!is_plain) return collapse_by_kernel(h, placing, position);
  const double along = placing.at == gone || !has_vertex_values_ ? 0
                       : placing.at == kept                      ? 1
                                            : closest_parameter(mesh_.position(gone), mesh_.position(kept), position);
  unite_ends(*edit_, gone, kept, along);
  plain_collapse(*edit_, h, [&](Edge stays, Edge goes) { surface_.take_over(stays, goes); });
  edit_->set_position(kept, position);
}

// Gives both ends the values of the place before the collapse unites them. Of vertices, where one end comes to the
// other, uniting is enough.
void Simplifier::carry_values(Halfedge h, const Placing& placing) {
  if (!(has_corner_values_ || (has_vertex_values_ && !placing.at))) return;
  const RingValues values(surface_, h, placing.place);
  if (has_corner_values_) values.write_corners(*edit_, h, placing.at);
  if (placing.at) return;
  const Vertex kept = mesh_.to(h);
  constexpr double whole[] = {1};
  values.write_vertex(*edit_, kept);
  edit_->blend(mesh_.from(h), {&kept, 1}, whole);
  if (const AttributeError* const fit = surface_.values()) fit->write_colours(*edit_, h, placing.place);
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

// The first rule that refuses it; `none` is said where none before that does.
EdgeRule Simplifier::refusal(const Freedom& freedom, const Placing& placing, EdgeRule none) const {
  const Halfedge h = freedom.halfedge;
  if (none <= EdgeRule::normal || surface_.turns_face(h, placing)) return std::min(none, EdgeRule::normal);
  if (surface_.narrows_face(h, placing.place)) return EdgeRule::angle;
  if (!is_within_error(h, placing)) return EdgeRule::error;
  if (none > EdgeRule::self_intersection && makes_faces_meet(freedom, placing)) return EdgeRule::self_intersection;
  return none > EdgeRule::distance && may_exceed_distance(freedom, placing) ? EdgeRule::distance : none;
}

EdgeRule Simplifier::rule_of(Edge e) const {
  const Freedom freedom = surface_.freedom(halfedge(e));
  if (legality(halfedge(e)) == Legality::none) return EdgeRule::structure;
  EdgeRule last = EdgeRule::structure;
  const auto add = [&](const Placing& placing) {
    const bool is_at_anchor = freedom.is_possible && placing.at == mesh_.to(freedom.halfedge);
    const bool is_held = freedom.is_anchored && !is_at_anchor;
    EdgeRule rule = is_held ? freedom.held_by : EdgeRule::free;
    // It costs the valence to see whether faces turn: that is not asked where it would tell nothing.
    if (!is_within_error(freedom.halfedge, placing)) rule = std::min(rule, EdgeRule::error);
    if (rule <= last) return;
    last = std::max(last, refusal(freedom, placing, rule));
  };
  const Freedom unheld{freedom.halfedge};
  const std::array<Placing, 3> others = surface_.others(unheld);
  // First those that move no hub.
  for (const Placing& other : others)
    if (other.at && is_hub(other.at)) add(other);
  add(surface_.lowest(unheld));
  for (const Placing& other : others) add(other);
  return last;
}

std::vector<std::uint8_t> find_remaining(const Mesh& mesh, const Simplifier& simplifier, Progress& progress) {
  std::vector<std::uint8_t> rules(mesh.edge_slots(), no_rule);
  const CollapseSurface::Standstill still = simplifier.standstill();
  for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
    if (i % 256 == 0 && !progress.go_on()) return rules;
    if (const Edge e(i); mesh.is_alive(e) && !mesh.is_wire(e) && !is_bridge(mesh, halfedge(e)))
      rules[i] = static_cast<std::uint8_t>(simplifier.rule_of(e));
  }
  sheet_groups(mesh).for_each([&](std::span<const Edge> sheets) {
    std::uint8_t first = no_rule;
    for (const Edge e : sheets) first = std::min(first, rules[e.index]);
    for (const Edge e : sheets)
      if (rules[e.index] != no_rule) rules[e.index] = first;
  });
  return rules;
}

std::vector<std::size_t> count_remaining(const Mesh& mesh, std::span<const std::uint8_t> rules) {
  std::vector<std::size_t> counts(edge_rule_table().size());
  for (const std::uint8_t rule : rules)
    if (rule != no_rule) ++counts[rule];
  sheet_groups(mesh).for_each([&](std::span<const Edge> sheets) {
    bool is_counted = false;
    for (const Edge e : sheets)
      if (const std::uint8_t rule = rules[e.index]; rule != no_rule && std::exchange(is_counted, true)) --counts[rule];
  });
  return counts;
}

}  // namespace ryosen
