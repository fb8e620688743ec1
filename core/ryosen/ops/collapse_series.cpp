#include "ryosen/ops/collapse_series.h"

#include <vector>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/face_polygon.h"
#include "ryosen/ops/rules/collapse_links.h"
#include "ryosen/ops/rules/corner_values.h"
#include "ryosen/ops/rules/face_geometry.h"

namespace ryosen {

Vertex CollapseSeries::number(Vertex slot) const {
  const auto found = numbers_.find(slot);
  return found == numbers_.end() ? slot : found->second;
}

std::optional<Rule> CollapseSeries::broken_rule(const AnyOp& op) {
  return std::get<CollapseEdge>(op).broken_rule(mesh(), known_);
}

std::uint32_t CollapseSeries::gaps(Vertex v) {
  const auto [count, is_new] = gaps_.try_emplace(v, 0);
  if (!is_new) return count->second;
  for (const Halfedge g : outgoing(mesh(), v)) {
    ++looks_;
    count->second += mesh().is_outside(g);
  }
  return count->second;
}

bool CollapseSeries::kept_is_smaller(Halfedge h) {
  for (Halfedge g = h, k = twin(h);;) {
    looks_ += 2;
    g = mesh().counter_clockwise(g);
    k = mesh().counter_clockwise(k);
    if (g == h) return false;
    if (k == twin(h)) return true;
  }
}

void CollapseSeries::apply(const AnyOp& any) {
  const CollapseEdge& op = std::get<CollapseEdge>(any);
  const Mesh& m = mesh();
  const Halfedge h = op.directed(m, known_);
  const Vertex gone = m.from(h), kept = m.to(h);
  std::optional<glm::dvec3> moved;
  if (op.place != CollapseEdge::Place::automatic) moved = op.position(m);
  if (!corner_attributes(m).empty())
    blend_corners(edit_, h, moved ? closest_parameter(m.position(gone), m.position(kept), *moved) : 1);
  known_.collapses(m, h);
  join(h, moved);
}

// The gap where the two ends have one between them, as it will be when the edge and the triangles at it are gone.
Halfedge CollapseSeries::only_gap_left(Halfedge h) const {
  const Mesh& m = mesh();
  const Halfedge at_kept = m.halfedge(m.to(h)), at_gone = m.halfedge(m.from(h));
  if (at_kept != twin(h) && m.is_outside(at_kept)) return at_kept;
  // A side that vanishes with its triangle hands its gap to the other one.
  return !m.is_outside(h) && is_triangle(m, h) && at_gone == twin(m.prev(h)) ? m.next(h) : at_gone;
}

void CollapseSeries::join(Halfedge h, std::optional<glm::dvec3> moved) {
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
  looks_ += renamed.size();

  OpEffect unheard;
  const Halfedge some = take_edge_out(edit_, h, unheard);
  for (const Halfedge g : renamed)
    if (m.is_alive(g)) edit_.set_from(g, slot);
  if (!hold) hold = gaps_left == 0 ? some : first_gap_clockwise(some);
  edit_.set_halfedge(slot, hold);
  move_point(edit_, slot, moved ? *moved : m.position(kept));
  give_number(slot, other, number(kept));
  gaps_.erase(other);
  gaps_[slot] = gaps_left;
}

// As the call by itself has it, which goes around counter-clockwise and takes the last.
Halfedge CollapseSeries::first_gap_clockwise(Halfedge from) {
  for (Halfedge g = mesh().clockwise(from); g != from; g = mesh().clockwise(g), ++looks_)
    if (mesh().is_outside(g)) return g;
  return from;
}

void CollapseSeries::give_number(Vertex slot, Vertex other, Vertex stays) {
  for (const Vertex v : {other, number(slot), number(other)})
    if (v != slot && v != stays && mesh().is_alive(v)) edit_.remove(v);
  numbers_.erase(other);
  numbers_[slot] = stays;
}

void CollapseSeries::finish() {
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

std::unique_ptr<OpSeries> collapses_in_series(Edit& edit) { return std::make_unique<CollapseSeries>(edit); }

}  // namespace ryosen
