#include "core/algo/remesh/surface_keeper.h"

#include <limits>

#include "core/mesh/circulate.h"

namespace ryosen::remesh {

SurfaceKeeper::SurfaceKeeper(const Mesh& mesh, const Features& features, double spacing, const WatchedPlaces& watched,
                             CrossingGuard::Surface surface)
    : mesh_(mesh), watched_(watched), points_(mesh, features, spacing) {
  if (!watched.is_empty()) guard_.emplace(mesh, surface);
}

bool SurfaceKeeper::refuses(bool would_meet) {
  refused_ += would_meet ? 1 : 0;
  return would_meet;
}

bool SurfaceKeeper::allows_collapse(Halfedge h, const glm::dvec3& place, double reach) {
  const Face left = mesh_.face(h), right = mesh_.face(twin(h));
  begin();
  for (const Face f : {left, right})
    if (f) old_.push_back(f);
  const bool stays = place == mesh_.position(mesh_.to(h));
  for (const Halfedge end : {h, twin(h)}) {
    if (stays && end != h) continue;
    for (const Halfedge out : outgoing(mesh_, mesh_.from(end))) {
      const Face f = mesh_.face(out);
      if (!f || f == left || f == right) continue;
      if (made_.size() > CoveredPoints::most_faces) return false;
      Corners corners = corners_of(mesh_, out);
      corners[0] = place;
      add(f, corners);
    }
  }
  // Those that stay as they are beside those that go may take points of these.
  if (stays)
    for (const Halfedge beside : {twin(mesh_.next(h)), twin(mesh_.prev(twin(h)))})
      if (const Face f = mesh_.face(beside)) made_.push_back({f, corners_of(mesh_, beside)});
  if (!points_.would_stay(old_, made_, reach)) return false;
  return !is_watched(place) || !refuses(guard_->would_meet(h, place));
}

void SurfaceKeeper::collapsed() {
  points_.hand_over();
  if (!guard_) return;
  for (const Face f : old_)
    if (mesh_.is_alive(f))
      guard_->follow(f);
    else
      guard_->forget(f);
}

bool SurfaceKeeper::allows_move(Vertex v, const glm::dvec3& place, double reach) {
  begin();
  for (const Halfedge out : outgoing(mesh_, v)) {
    if (mesh_.is_outside(out)) continue;
    if (made_.size() > CoveredPoints::most_faces) return false;
    Corners corners = corners_of(mesh_, out);
    corners[0] = place;
    add(mesh_.face(out), corners);
  }
  if (!points_.would_stay(old_, made_, reach)) return false;
  return !is_watched(place) || !refuses(guard_->would_meet(v, place));
}

void SurfaceKeeper::moved(Vertex v) {
  points_.hand_over();
  if (guard_) guard_->follow_move(v);
}

bool SurfaceKeeper::allows_swap(Halfedge h, double reach) {
  const Halfedge o = twin(h);
  const glm::dvec3 &a = mesh_.position(mesh_.from(h)), &b = mesh_.position(mesh_.to(h)),
                   &c = mesh_.position(mesh_.from(mesh_.prev(h))), &d = mesh_.position(mesh_.from(mesh_.prev(o)));
  begin();
  add(mesh_.face(h), {c, a, d});
  add(mesh_.face(o), {d, b, c});
  if (!points_.would_stay(old_, made_, reach)) return false;
  return !is_watched(0.5 * a + 0.5 * b) || !refuses(guard_->would_meet_swapped(h));
}

void SurfaceKeeper::swapped(Halfedge h) {
  points_.hand_over();
  if (!guard_) return;
  guard_->follow(mesh_.face(h));
  guard_->follow(mesh_.face(twin(h)));
}

bool SurfaceKeeper::allows_split(Halfedge h, const glm::dvec3& place) {
  return !is_watched(place) || !refuses(guard_->would_meet_split(h, place));
}

void SurfaceKeeper::split(Vertex first_copy, Face first_new) {
  for (Vertex v = first_copy; v.index < mesh_.vertex_slots(); ++v.index) {
    begin();
    for (const Halfedge out : outgoing(mesh_, v)) {
      const Face f = mesh_.face(out);
      if (!f) continue;
      if (f.index < first_new.index) old_.push_back(f);
      made_.push_back({f, corners_of(mesh_, out)});
    }
    if (points_.would_stay(old_, made_, std::numeric_limits<double>::infinity())) points_.hand_over();
    if (guard_) guard_->follow(v);
  }
}

}  // namespace ryosen::remesh
