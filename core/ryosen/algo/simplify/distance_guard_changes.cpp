// Each kind of change that a DistanceGuard is asked about marks the faces that change and tells the new ones.
#include <algorithm>
#include <bit>

#include "ryosen/algo/simplify/distance_guard.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/mesh/circulate.h"

namespace ryosen {

bool DistanceGuard::is_hub(Vertex v) const {
  std::size_t faces = 0;
  for (const Halfedge out : outgoing(mesh_, v))
    if (mesh_.face(out) && ++faces > most_changed) return true;
  return false;
}

bool DistanceGuard::moves_hub(std::span<const Moved> moved) const {
  return std::any_of(moved.begin(), moved.end(), [&](const Moved& move) {
    return mesh_.position(move.vertex) != move.position && is_hub(move.vertex);
  });
}

bool DistanceGuard::moves_hub(Halfedge h, const glm::dvec3& position) const {
  return moves_hub(std::array{Moved{mesh_.from(h), position}, Moved{mesh_.to(h), position}});
}

void DistanceGuard::move_together(std::span<const Moved> moved) {
  const auto place_of = [&](Vertex v) {
    for (const auto& [vertex, position] : moved)
      if (vertex == v) return scale_.scaled(position);
    return scale_.scaled(mesh_.position(v));
  };
  for (const auto& [vertex, position] : moved) {
    if (mesh_.position(vertex) == position) continue;
    old_inner_.push_back(scale_.scaled(mesh_.position(vertex)));
    for (const Halfedge out : outgoing(mesh_, vertex)) {
      const Face f = mesh_.face(out);
      if (!f || is_marked(f.index)) continue;
      mark_changing(f);
      add_changed(f, {place_of(vertex), place_of(mesh_.to(out)), place_of(mesh_.from(mesh_.prev(out)))});
    }
  }
}

std::uint64_t DistanceGuard::key_of(Halfedge h, const glm::dvec3& position) const {
  std::uint64_t key = edge(h).index;
  const auto add = [&](double x) {
    key = (key ^ std::bit_cast<std::uint64_t>(x)) * 0x9E3779B97F4A7C15u, key ^= key >> 29;
  };
  for (int i = 0; i < 3; ++i) add(position[i]);
  for (const NearTarget& old : old_targets_)
    for (const glm::dvec3& corner : old.corners) add(corner.x), add(corner.y), add(corner.z);
  return key;
}

bool DistanceGuard::collapse_may_exceed(Halfedge h, const glm::dvec3& position) {
  const std::array<Moved, 2> ends{Moved{mesh_.from(h), position}, Moved{mesh_.to(h), position}};
  if (!is_finite(position) || moves_hub(ends)) return true;
  begin_question();
  for (const Halfedge side : {h, twin(h)})
    if (const Face f = mesh_.face(side)) mark_changing(f);
  new_inner_ = {scale_.scaled(position)};
  move_together(ends);
  // Both faces that go may be near those beside them.
  for (const Halfedge side : {h, twin(h)}) {
    if (mesh_.is_outside(side)) continue;
    for (const Halfedge beside : {twin(mesh_.next(side)), twin(mesh_.prev(side))})
      if (const Face f = mesh_.face(beside); f && !is_marked(f.index)) add_target(f, corners_of(f));
  }
  const std::uint64_t key = key_of(h, position);
  std::uint64_t& refused = refused_[key & (refused_.size() - 1)];
  if (refused == key) return true;
  const bool is_refused = may_exceed();
  if (is_refused) refused = key;
  return is_refused;
}

bool DistanceGuard::move_may_exceed(Vertex v, const glm::dvec3& position) {
  const Moved moved{v, position};
  if (!is_finite(position) || moves_hub({&moved, 1})) return true;
  begin_question();
  new_inner_ = {scale_.scaled(position)};
  move_together({&moved, 1});
  return may_exceed();
}

bool DistanceGuard::swap_may_exceed(Halfedge h) {
  begin_question();
  const auto at = [&](Halfedge corner) { return scale_.scaled(mesh_.position(mesh_.from(corner))); };
  const glm::dvec3 a = at(h), b = at(twin(h)), c = at(mesh_.prev(h)), d = at(mesh_.prev(twin(h)));
  const Face left = mesh_.face(h), right = mesh_.face(twin(h));
  mark_changing(left);
  mark_changing(right);
  add_changed(left, {d, c, a});
  add_changed(right, {c, d, b});
  return may_exceed();
}

// Nothing goes, so that the input stays as near as it was.
bool DistanceGuard::filling_may_exceed(const std::array<Halfedge, 3>& sides) {
  if (std::any_of(sides.begin(), sides.end(), [&](Halfedge side) { return is_hub(mesh_.from(side)); })) return true;
  begin_question();
  for (const Halfedge side : sides) {
    const Vertex v = mesh_.from(side);
    old_inner_.push_back(scale_.scaled(mesh_.position(v)));
    for (const Face f : faces_around(mesh_, v))
      if (f && !is_marked(f.index)) mark_changing(f);
  }
  find_listed();
  changed_.push_back({Face(), {old_inner_[0], old_inner_[1], old_inner_[2]}});
  return !(most_ > 0) || !is_finite(old_inner_[0] + old_inner_[1] + old_inner_[2]) || are_faces_plainly_far() ||
         !prove_faces();
}

void DistanceGuard::follow_filling(const std::array<Face, 2>& added) {
  for (const Face f : added) {
    if (f.index >= bounds_.size()) {
      first_of_face_.resize(f.index + 1, no_index);
      bounds_.resize(f.index + 1);
      marks_.resize(f.index + 1);
    }
    bounds_[f.index] = changed_.front().bound;
  }
}

bool DistanceGuard::joining_may_exceed(const std::array<Halfedge, 3>& sides, const std::array<Halfedge, 3>& against,
                                       const std::array<glm::dvec3, 3>& places) {
  std::array<Moved, 6> moved;
  for (std::size_t i = 0; i < 3; ++i) {
    moved[2 * i] = {mesh_.from(sides[i]), places[i]};
    moved[2 * i + 1] = {mesh_.to(against[i]), places[i]};
  }
  if (moves_hub(moved)) return true;
  begin_question();
  for (const glm::dvec3& place : places) new_inner_.push_back(scale_.scaled(place));
  mark_changing(mesh_.face(sides[0]));
  mark_changing(mesh_.face(against[0]));
  move_together(moved);
  return may_exceed();
}

}  // namespace ryosen
