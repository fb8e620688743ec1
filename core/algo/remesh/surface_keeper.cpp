#include "core/algo/remesh/surface_keeper.h"

#include <limits>

#include "core/mesh/circulate.h"

namespace ryosen::remesh {

namespace {

constexpr double any_way = std::numeric_limits<double>::infinity(), anywhere = std::numeric_limits<double>::max();

}  // namespace

SurfaceKeeper::SurfaceKeeper(const Mesh& mesh, const Features& features, double spacing, const WatchedPlaces& watched,
                             CrossingGuard::Surface surface)
    : mesh_(mesh), watched_(watched), points_(mesh, features, spacing) {
  if (!watched.is_empty()) guard_.emplace(mesh, surface);
}

bool SurfaceKeeper::refuses(bool would_meet) {
  refused_ += would_meet ? 1 : 0;
  return would_meet;
}

bool SurfaceKeeper::add_around(Vertex v, const glm::dvec3& place, Face left, Face right) {
  const double moved = glm::distance(place, mesh_.position(v));
  for (const Halfedge out : outgoing(mesh_, v)) {
    const Face f = mesh_.face(out);
    if (!f || f == left || f == right) continue;
    if (changes_.size() > CoveredPoints::most_faces) return false;
    Corners corners = corners_of(mesh_, out);
    corners[0] = place;
    add(f, Kind::becomes, corners, moved);
  }
  return true;
}

bool SurfaceKeeper::allows_collapse(Halfedge h, const glm::dvec3& place, double reach) {
  const Face left = mesh_.face(h), right = mesh_.face(twin(h));
  changes_.clear();
  for (const Face f : {left, right})
    if (f) add(f, Kind::goes);
  if (!add_around(mesh_.from(h), place, left, right)) return false;
  if (place != mesh_.position(mesh_.to(h))) {
    if (!add_around(mesh_.to(h), place, left, right)) return false;
  } else {
    // Those that stay as they are beside those that go may take points of these.
    for (const Halfedge beside : {twin(mesh_.next(h)), twin(mesh_.prev(twin(h)))})
      if (const Face f = mesh_.face(beside)) add(f, Kind::comes_or_stays, corners_of(mesh_, beside));
  }
  if (!points_.would_stay(changes_, reach, 0.5 * reach)) return false;
  return !is_watched(place) || !refuses(guard_->would_meet(h, place));
}

void SurfaceKeeper::collapsed() {
  points_.hand_over();
  if (!guard_) return;
  for (const CoveredPoints::Change& change : changes_)
    if (change.kind == Kind::goes)
      guard_->forget(change.face);
    else
      guard_->follow(change.face);
}

bool SurfaceKeeper::keeps_points(Vertex v, const glm::dvec3& place, double reach) {
  points_.begin_move(glm::distance(place, mesh_.position(v)));
  for (const Halfedge out : outgoing(mesh_, v)) {
    if (mesh_.is_outside(out)) continue;
    Corners corners = corners_of(mesh_, out);
    corners[0] = place;
    if (!points_.keeps_points(mesh_.face(out), area_normal(corners), reach)) return false;
  }
  return true;
}

bool SurfaceKeeper::allows_move(Vertex v, const glm::dvec3& place, double reach) {
  if (!keeps_points(v, place, reach)) {
    changes_.clear();
    if (!add_around(v, place) || !points_.would_stay(changes_, reach, 0.5 * reach)) return false;
  }
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
  changes_.clear();
  add(mesh_.face(h), Kind::becomes, {c, a, d}, any_way);
  add(mesh_.face(o), Kind::becomes, {d, b, c}, any_way);
  if (!points_.would_stay(changes_, reach, 0.5 * reach)) return false;
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
    changes_.clear();
    for (const Halfedge out : outgoing(mesh_, v))
      if (const Face f = mesh_.face(out))
        add(f, f.index < first_new.index ? Kind::becomes : Kind::comes_or_stays, corners_of(mesh_, out), any_way);
    if (points_.would_stay(changes_, anywhere, 0)) points_.hand_over();
    if (guard_) guard_->follow(v);
  }
}

}  // namespace ryosen::remesh
