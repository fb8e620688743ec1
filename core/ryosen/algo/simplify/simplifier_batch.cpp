// How a simplifier takes edges from its queue: many at once. What an edge asks lies far from what the others ask in
// memory, and while one waits for it the others do not have to.
#include <array>

#include "ryosen/algo/simplify/simplifier.h"
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

}  // namespace ryosen
