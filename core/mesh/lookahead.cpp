#include "core/mesh/lookahead.h"

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
  fetch(halfedge(e, 0));
}

void Lookahead::begin(Walks& walks) const {
  walks.begins = false;
  const Halfedge h = walks.counter_clockwise, o = walks.clockwise;
  if (!mesh_.exists(h) || !mesh_.is_alive(h)) return;
  for (Halfedge side : {h, o}) {
    fetch(mesh_.from(side));
    fetch(mesh_.face(side));
    fetch(mesh_.next(side));
    fetch(mesh_.prev(side));
  }
  if (around_ == Around::apexes) walks = {twin(mesh_.next(h)), mesh_.prev(h)};
}

void Lookahead::step(Walks& walks) const {
  if (mesh_.exists(walks.counter_clockwise)) {
    if (around_ == Around::ends) fetch(mesh_.face(walks.counter_clockwise));
    walks.counter_clockwise = mesh_.counter_clockwise(walks.counter_clockwise);
    fetch(walks.counter_clockwise);
  }
  if (mesh_.exists(walks.clockwise)) {
    if (around_ == Around::ends) fetch(mesh_.face(walks.clockwise));
    walks.clockwise = mesh_.clockwise(walks.clockwise);
    fetch(walks.clockwise);
  }
}

}  // namespace ryosen
