#include "ryosen/mesh/prefetch.h"

namespace ryosen {

void Lookahead::announce(Edge e) {
  for (Walks& walks : announced_) {
    if (walks.begins)
      begin(walks);
    else
      step(walks);
  }
  announced_[next_place_] = {halfedge(e, 0), halfedge(e, 1), true};
  next_place_ = (next_place_ + 1) % distance;
  prefetch(mesh_, halfedge(e, 0));
}

void Lookahead::begin(Walks& walks) const {
  walks.begins = false;
  const Halfedge h = walks.counter_clockwise, o = walks.clockwise;
  if (!mesh_.exists(h) || !mesh_.is_alive(h)) return;
  for (Halfedge side : {h, o}) {
    prefetch(mesh_, mesh_.from(side));
    prefetch(mesh_, mesh_.face(side));
    prefetch(mesh_, mesh_.next(side));
    prefetch(mesh_, mesh_.prev(side));
  }
  if (around_ == Around::apexes) walks = {twin(mesh_.next(h)), mesh_.prev(h)};
}

void Lookahead::step(Walks& walks) const {
  if (mesh_.exists(walks.counter_clockwise)) {
    if (around_ == Around::ends) prefetch(mesh_, mesh_.face(walks.counter_clockwise));
    walks.counter_clockwise = mesh_.counter_clockwise(walks.counter_clockwise);
    prefetch(mesh_, walks.counter_clockwise);
  }
  if (mesh_.exists(walks.clockwise)) {
    if (around_ == Around::ends) prefetch(mesh_, mesh_.face(walks.clockwise));
    walks.clockwise = mesh_.clockwise(walks.clockwise);
    prefetch(mesh_, walks.clockwise);
  }
}

}  // namespace ryosen
