#include "ryosen/algo/remesh/surface_keeper.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ryosen/mesh/circulate.h"

namespace ryosen::remesh {

namespace {

using Kind = CoveredStep::Change::Kind;

constexpr double any_way = std::numeric_limits<double>::infinity(), anywhere = std::numeric_limits<double>::max();

}  // namespace

std::size_t WatchedPlaces::Hash::operator()(const Cell& c) const {
  std::uint64_t mixed = 0;
  for (const std::int64_t x : c) mixed = (mixed ^ static_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15u;
  return static_cast<std::size_t>(mixed ^ mixed >> 32u);
}

WatchedPlaces::Cell WatchedPlaces::cell_of(const glm::dvec3& place) const {
  Cell cell;
  for (int axis = 0; axis < 3; ++axis)
    cell[static_cast<std::size_t>(axis)] =
        static_cast<std::int64_t>(std::clamp(std::floor(place[axis] / cell_), -1e18, 1e18));
  return cell;
}

void WatchedPlaces::add(const Box& box) {
  constexpr double most_cells = 100000;
  const Cell low = cell_of(box.lowest), high = cell_of(box.highest);
  double count = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) count *= static_cast<double>(high[axis] - low[axis]) + 3;
  is_all_ |= !(count + static_cast<double>(cells_.size()) < most_cells);
  if (is_all_) return;
  for (std::int64_t x = low[0] - 1; x <= high[0] + 1; ++x)
    for (std::int64_t y = low[1] - 1; y <= high[1] + 1; ++y)
      for (std::int64_t z = low[2] - 1; z <= high[2] + 1; ++z) cells_.insert({x, y, z});
}

SurfaceKeeper::SurfaceKeeper(const Mesh& mesh, CoveredPoints points, const WatchedPlaces& watched, const MetPlaces& met)
    : mesh_(mesh), watched_(watched), met_(met), points_(std::move(points)), step_(points_) {
  if (!watched.is_empty()) guard_.emplace(mesh, met);
}

void SurfaceKeeper::widen(double reach) {
  widened_ = reach;
  if (!std::isfinite(reach)) {
    if (!guard_) guard_.emplace(mesh_, met_);
    guard_->count();
  } else if (watched_.is_empty()) {
    guard_.reset();
  }
}

bool SurfaceKeeper::stays_near(std::span<const CoveredStep::Change> changes, double reach, CoveredStep& step) const {
  return step.would_stay(changes, widened_ * reach, 0.5 * widened_ * reach);
}

bool SurfaceKeeper::refuses(bool would_meet) {
  refused_ += would_meet ? 1 : 0;
  return would_meet;
}

bool SurfaceKeeper::add_around(Changes& changes, Vertex v, const glm::dvec3& place, Face left, Face right) const {
  const double moved = glm::distance(place, mesh_.position(v));
  for (const Halfedge out : outgoing(mesh_, v)) {
    const Face f = mesh_.face(out);
    if (!f || f == left || f == right) continue;
    if (changes.size() > CoveredStep::most_faces) return false;
    Corners corners = corners_of(mesh_, out);
    corners[0] = place;
    changes.push_back({f, Kind::becomes, corners, moved});
  }
  return true;
}

bool SurfaceKeeper::allows_collapse(Halfedge h, const glm::dvec3& place, double reach) {
  const Face left = mesh_.face(h), right = mesh_.face(twin(h));
  changes_.clear();
  for (const Face f : {left, right})
    if (f) changes_.push_back({f, Kind::goes, {}});
  if (!add_around(changes_, mesh_.from(h), place, left, right)) return false;
  if (place != mesh_.position(mesh_.to(h))) {
    if (!add_around(changes_, mesh_.to(h), place, left, right)) return false;
  } else {
    // Those that stay as they are beside those that go may take points of these.
    const Halfedge before = mesh_.prev(twin(h)), after = mesh_.next(h);
    for (const Halfedge beside : {left ? twin(after) : h, right ? twin(before) : twin(h)})
      if (const Face f = mesh_.face(beside)) changes_.push_back({f, Kind::comes_or_stays, corners_of(mesh_, beside)});
  }
  if (!stays_near(changes_, reach, step_)) return false;
  return !is_watched(place) || !refuses(guard_->would_meet(h, place));
}

void SurfaceKeeper::collapsed() {
  step_.hand_over();
  if (!guard_) return;
  for (const CoveredStep::Change& change : changes_)
    if (change.kind == Kind::goes)
      guard_->forget(change.face);
    else
      guard_->follow(change.face);
}

bool SurfaceKeeper::may_move_beside() {
  points_.make_room(mesh_.face_slots());
  return !guard_;
}

// Whether it is plain that each face around keeps its points.
bool SurfaceKeeper::MoveJudge::keeps_points(Vertex v, const glm::dvec3& place, double reach) {
  const Mesh& mesh = keeper_.mesh_;
  step_.begin_move(glm::distance(place, mesh.position(v)));
  for (const Halfedge out : outgoing(mesh, v)) {
    if (mesh.is_outside(out)) continue;
    Corners corners = corners_of(mesh, out);
    corners[0] = place;
    if (!step_.keeps_points(mesh.face(out), area_normal(corners), keeper_.widened_ * reach)) return false;
  }
  return true;
}

bool SurfaceKeeper::MoveJudge::allows(Vertex v, const glm::dvec3& place, double reach) {
  if (!keeps_points(v, place, reach)) {
    changes_.clear();
    if (!keeper_.add_around(changes_, v, place) || !keeper_.stays_near(changes_, reach, step_)) return false;
  }
  return !keeper_.is_watched(place) || !keeper_.refuses(keeper_.guard_->would_meet(v, place));
}

void SurfaceKeeper::MoveJudge::moved(Vertex v) {
  step_.hand_over();
  if (keeper_.guard_) keeper_.guard_->follow_move(v);
}

bool SurfaceKeeper::allows_swap(Halfedge h, double reach) {
  const Halfedge o = twin(h);
  const glm::dvec3 &a = mesh_.position(mesh_.from(h)), &b = mesh_.position(mesh_.to(h)),
                   &c = mesh_.position(mesh_.from(mesh_.prev(h))), &d = mesh_.position(mesh_.from(mesh_.prev(o)));
  changes_.clear();
  changes_.push_back({mesh_.face(h), Kind::becomes, {c, a, d}, any_way});
  changes_.push_back({mesh_.face(o), Kind::becomes, {d, b, c}, any_way});
  if (!stays_near(changes_, reach, step_)) return false;
  return !is_watched(0.5 * a + 0.5 * b) || !refuses(guard_->would_meet_swapped(h));
}

void SurfaceKeeper::swapped(Halfedge h) {
  step_.hand_over();
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
        changes_.push_back(
            {f, f.index < first_new.index ? Kind::becomes : Kind::comes_or_stays, corners_of(mesh_, out), any_way});
    if (step_.would_stay(changes_, anywhere, 0)) step_.hand_over();
    if (guard_) guard_->follow(v);
  }
}

}  // namespace ryosen::remesh
