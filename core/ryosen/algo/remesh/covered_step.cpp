#include "ryosen/algo/remesh/covered_step.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ryosen/geometry/closest.h"

namespace ryosen::remesh {

bool CoveredStep::are_at_one(const glm::dvec3& area_normal, const Point& point) {
  const double product = glm::dot(area_normal, point.normal);
  return product >= 0 || product >= CoveredPoints::least_facing * glm::length(area_normal);
}

bool CoveredStep::faces(const Point& point, std::size_t change) const {
  return changes_[change].kind != Change::Kind::goes && (is_any_way_ || are_at_one(normals_[change], point));
}

double CoveredStep::distance(const Point& point, std::size_t change) const {
  const auto& [a, b, c] = changes_[change].corners;
  return glm::length(way_from_triangle(a, b, c, point.place));
}

// Of one of the points of a face. Its own face is taken where it is near enough, without a look at the others.
bool CoveredStep::find_answer(std::uint32_t i, std::size_t own, double reach, double near_enough) {
  const Point& point = covered_.points_[i];
  const bool has_own = faces(point, own);
  double own_distance = std::numeric_limits<double>::infinity();
  if (has_own) {
    if (const double most = point.distance + changes_[own].moved; most <= reach) {
      answers_.push_back({i, changes_[own].face, most});
      return true;
    }
    own_distance = distance(point, own);
  }
  Answer answer{i, changes_[own].face, own_distance};
  for (std::size_t k = 0; k < changes_.size() && answer.distance > near_enough; ++k)
    if (k != own && faces(point, k))
      if (const double found = distance(point, k); found < answer.distance) answer = {i, changes_[k].face, found};
  if (!(answer.distance <= std::max(reach, point.distance))) return false;
  answers_.push_back(answer);
  return true;
}

bool CoveredStep::would_stay(std::span<const Change> changes, double reach, double near_enough) {
  answers_.clear();
  normals_.clear();
  old_.clear();
  changes_ = changes;
  is_any_way_ = !std::isfinite(reach);
  is_move_ = false;
  if (changes.size() > most_faces) return false;
  for (const Change& change : changes)
    normals_.push_back(change.kind == Change::Kind::goes ? glm::dvec3(0) : area_normal(change.corners));
  for (std::size_t k = 0; k < changes.size(); ++k) {
    const Face f = changes[k].face;
    if (changes[k].kind == Change::Kind::comes_or_stays || f.index >= covered_.first_.size()) continue;
    old_.push_back(f);
    for (std::uint32_t i = covered_.first_[f.index]; i != no_index; i = covered_.points_[i].next)
      if (!find_answer(i, k, reach, near_enough)) return false;
  }
  return true;
}

void CoveredStep::begin_move(double moved) {
  old_.clear();
  answers_.clear();
  is_move_ = true;
  moved_ = moved;
}

bool CoveredStep::keeps_points(Face f, const glm::dvec3& area_normal, double reach) {
  if (f.index >= covered_.first_.size()) return true;
  old_.push_back(f);
  for (std::uint32_t i = covered_.first_[f.index]; i != no_index;) {
    const Point& point = covered_.points_[i];
    if (!(point.distance + moved_ <= reach) || !are_at_one(area_normal, point)) return false;
    i = point.next;
  }
  return true;
}

void CoveredStep::hand_over() {
  for (const Face f : old_) {
    if (is_move_)
      for (std::uint32_t i = covered_.first_[f.index]; i != no_index; i = covered_.points_[i].next)
        covered_.points_[i].distance += moved_;
    else
      covered_.first_[f.index] = no_index;
  }
  for (const Answer& answer : answers_) {
    covered_.points_[answer.point].distance = answer.distance;
    covered_.give(answer.point, answer.face);
  }
}

}  // namespace ryosen::remesh
