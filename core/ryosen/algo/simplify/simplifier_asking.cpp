// How a simplifier asks about edges: many at once, since what an edge asks lies far from what the others ask in memory,
// and while one waits for it the others do not have to; and about those at a hub from their other ends, so that n edges
// of one do not cost n squared.
#include <array>

#include "ryosen/algo/simplify/simplifier.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/prefetch.h"

namespace ryosen {

namespace {

constexpr std::size_t batch_size = 256;
// How many edges ahead the links and what the ends stand for are asked from memory.
constexpr std::size_t links_ahead = 16, ends_ahead = 8;

// A walk around a vertex.
struct Walk {
  Halfedge start, at;
  std::size_t steps = 0;
};

}  // namespace

// Edges of one level whose turn it is, those alone that are not for a later one; false where the queue is empty.
bool Simplifier::take_batch() {
  batch_.clear();
  if (!queue_.next()) return false;
  for (std::size_t i = 0; i < batch_size; ++i) {
    prefetch(mesh_, halfedge(Edge(queue_.ahead(links_ahead))));
    surface_.prefetch_ends(Edge(queue_.ahead(ends_ahead)));
    if (const Edge e(queue_.number()); mesh_.is_alive(e) && !mesh_.is_wire(e)) ask(e);
    if (i + 1 == batch_size || !queue_.next_on_level()) break;
  }
  return true;
}

void Simplifier::ask(Edge e) {
  ++asked_;
  const Freedom freedom = surface_.freedom(halfedge(e));
  if (!freedom.is_possible) return block(e);
  const Placing lowest = surface_.lowest(freedom);
  if (const auto level = queue_.level_of(lowest.cost); level > queue_.current())
    queue_.add(e.index, level);
  else
    batch_.push_back({e, freedom, lowest, surface_.history(freedom.halfedge)});
}

// Asks from memory what the collapses of a batch will walk along: around both ends of each, several walks together.
// Around a hub nothing walks for each of its edges, so that this does not either.
void Simplifier::warm_rings() {
  constexpr std::size_t together = 16, most_steps = 64;
  std::array<Walk, together> walks;
  std::size_t next = 0, active = 0;
  const std::size_t all = 2 * batch_.size();
  const auto begin = [&](Walk& walk) {
    const Halfedge h = batch_[next / 2].freedom.halfedge;
    walk.start = walk.at = next++ % 2 == 0 ? h : twin(h);
    walk.steps = 0;
  };
  while (active < together && next < all) begin(walks[active++]);
  while (active > 0)
    for (std::size_t i = 0; i < active;) {
      Walk& walk = walks[i];
      surface_.prefetch_place(mesh_.to(walk.at));
      walk.at = twin(mesh_.prev(walk.at));
      prefetch(mesh_, walk.at);
      ++warmed_;
      if (walk.at != walk.start && ++walk.steps < most_steps) {
        ++i;
      } else if (next < all) {
        begin(walk);
        ++i;
      } else {
        walk = walks[--active];
      }
    }
}

bool Simplifier::is_hub(Vertex v) const { return ryosen::is_hub(mesh_, v); }

// What edges around a vertex and around its neighbours ask has changed: their levels are in the past or still to come.
// Of a hub only those to what has changed; find_further() asks the others in the end.
void Simplifier::unblock_around(Vertex v, const std::array<Vertex, 2>& apexes) {
  const auto unblock = [&](Edge e) {
    if (!is_blocked_[e.index]) return;
    is_blocked_[e.index] = 0;
    queue_.add(e.index, queue_.current());
  };
  const auto unblock_all = [&](Vertex w) {
    has_blocked_[w.index] = 0;
    for (Halfedge h : outgoing(mesh_, w)) unblock(edge(h));
  };
  if (!is_hub(v)) {
    if (has_blocked_[v.index]) unblock_all(v);
    for (Halfedge h : outgoing(mesh_, v))
      if (const Vertex w = mesh_.to(h); has_blocked_[w.index]) is_hub(w) ? unblock(edge(h)) : unblock_all(w);
    return;
  }
  for (Vertex apex : apexes)
    if (apex && mesh_.is_alive(apex) && has_blocked_[apex.index] && !is_hub(apex)) unblock_all(apex);
}

bool Simplifier::is_plain_at_hub(Halfedge h) const {
  const Vertex a = mesh_.from(h), b = mesh_.to(h);
  return has_triangles_alone_ && (is_hub(a) || is_hub(b)) && !known_.has_several_fans(mesh_, a) &&
         !known_.has_several_fans(mesh_, b);
}

QuickAnswer Simplifier::collapse_at_hub(Halfedge h) const {
  if (is_hub(mesh_.from(h))) h = twin(h);
  const Vertex small = mesh_.from(h), hub = mesh_.to(h);
  if (is_hub(small)) return QuickAnswer::unknown;
  const bool is_inner = !mesh_.is_outside(h) && !mesh_.is_outside(twin(h));
  if (is_inner && mesh_.is_boundary(small) && mesh_.is_boundary(hub)) return QuickAnswer::refused;
  if (shares_neighbours_with_hub(h)) return QuickAnswer::refused;
  const Halfedge second = mesh_.counter_clockwise(h);
  const bool has_three_edges = second != h && mesh_.counter_clockwise(second) != h;
  return is_inner && !mesh_.is_boundary(small) && has_three_edges ? QuickAnswer::legal : QuickAnswer::unknown;
}

// Whether a neighbour of the small end, where h begins, is one of the hub too beside the apexes of the triangles at h.
bool Simplifier::shares_neighbours_with_hub(Halfedge h) const {
  const Vertex hub = mesh_.to(h);
  const auto is_apex = [&](Vertex v) {
    return (!mesh_.is_outside(h) && v == mesh_.from(mesh_.prev(h))) ||
           (!mesh_.is_outside(twin(h)) && v == mesh_.to(mesh_.next(twin(h))));
  };
  for (Halfedge g : outgoing(mesh_, mesh_.from(h)))
    if (const Vertex v = mesh_.to(g); v != hub && !is_apex(v) && are_joined(v, hub)) return true;
  return false;
}

bool Simplifier::are_joined(Vertex v, Vertex hub) const {
  if (!is_hub(v)) {
    for (Halfedge g : outgoing(mesh_, v))
      if (mesh_.to(g) == hub) return true;
    return false;
  }
  const auto [known, is_new] = hub_pairs_.try_emplace({std::min(v, hub), std::max(v, hub)});
  HubPair& pair = known->second;
  const auto history = surface_.history(known->first.first, known->first.second);
  if (pair.edge && mesh_.is_alive(pair.edge)) {
    const auto [a, b] = ends(mesh_, pair.edge);
    if (std::min(a, b) == known->first.first && std::max(a, b) == known->first.second) return true;
  }
  if (!is_new && !pair.edge && pair.history == history) return false;
  const Halfedge between = any_sheet_between(mesh_, v, hub);
  pair = {between ? edge(between) : Edge(), history};
  return bool(between);
}

}  // namespace ryosen
