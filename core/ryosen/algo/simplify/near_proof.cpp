#include "ryosen/algo/simplify/near_proof.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ryosen/geometry/closest.h"
#include "ryosen/geometry/unit_vector.h"

namespace ryosen {

namespace {

// Distances up to this are those of rounding.
constexpr double smallest_bound = 0x1p-48;
constexpr unsigned most_cuts = 3;
// So many are not all compared with a polygon that is not small.
constexpr std::size_t many_targets = 12;

// A point is at least so far from what a target counts for: from its box, less what rounding may add, and the bound.
double least_distance(const glm::dvec3& p, const NearTarget& target) {
  constexpr double rounding = 1e-12;
  const glm::dvec3 way = glm::max(glm::max(target.box.lowest - p, p - target.box.highest), glm::dvec3(0.0));
  return (1 - rounding) * glm::length(way) + target.bound;
}

}  // namespace

bool are_apart(const Box& a, const Box& b, double gap) {
  for (int i = 0; i < 3; ++i)
    if (a.lowest[i] > b.highest[i] + gap || b.lowest[i] > a.highest[i] + gap) return true;
  return false;
}

NearTarget target_of(const TriangleCorners& corners, double bound) {
  NearTarget target{corners, bound};
  for (const glm::dvec3& corner : corners) target.box.add(corner);
  return target;
}

double distance_to_triangle(const NearTarget& target, const glm::dvec3& p) {
  const auto& [a, b, c] = target.corners;
  return glm::length(way_from_triangle(a, b, c, p));
}

bool NearProof::prove(const TriangleCorners& triangle, std::span<const NearTarget> targets,
                      std::span<const glm::dvec3> inner, const Limits& limits) {
  targets_ = targets;
  limits_ = limits;
  level_ = std::min(std::max(smallest_bound, limits.start), limits.most);
  pieces_ = depth_ = deepest_ = 0;
  active_.clear();
  used_.clear();
  inner_.assign(inner.begin(), inner.end());
  normal_ = unit_or_zero(area_normal(triangle));
  for (std::uint32_t i = 0; i < targets.size(); ++i) active_.push_back(i);
  Polygon polygon;
  for (const glm::dvec3& corner : triangle) polygon.add(corner);
  return prove(polygon, {0, active_.size(), 0, inner_.size()}, {});
}

bool NearProof::prove(const Polygon& polygon, Active among, const Origin& origin) {
  if (depth_ == most_depth) return false;
  deepest_ = std::max(deepest_, ++depth_);
  const Box box = polygon.box();
  const std::size_t begin = active_.size();
  for (std::size_t i = among.begin; i < among.end; ++i)
    if (!are_apart(box, targets_[active_[i]].box, limits_.most)) active_.push_back(active_[i]);
  const std::size_t inner_begin = inner_.size();
  for (std::size_t i = among.inner_begin; i < among.inner_end; ++i) {
    const glm::dvec3 place = inner_[i];
    if (!are_apart(box, {place, place}, limits_.most)) inner_.push_back(place);
  }
  const bool is_near = prove_near(polygon, {begin, active_.size(), inner_begin, inner_.size()}, origin);
  active_.resize(begin);
  inner_.resize(inner_begin);
  --depth_;
  return is_near;
}

bool NearProof::prove_near(const Polygon& polygon, Active active, const Origin& origin) {
  if (++pieces_ > limits_.pieces && !raise_further()) return false;
  if (active.end - active.begin > many_targets && polygon.side_length(polygon.longest_side()) > limits_.most) {
    if (nearest_covers(polygon, active)) return true;
    if (const auto middle = find_inner(polygon, active)) return prove_around(polygon, *middle, active);
    return prove_halves(polygon, active);
  }
  double need = 0;
  Best best = find_best(polygon, active, origin.cut_by, need);
  if (need > level_) {
    if (!raise_to(need)) return false;
    best = find_best(polygon, active, origin.cut_by, need);
  }
  if (best.covered == 0) return false;
  if (best.covered == polygon.count) {
    note_used(best.target);
    return true;
  }
  if (const auto middle = find_inner(polygon, active)) return prove_around(polygon, *middle, active);
  if (polygon.count == most_corners || origin.cuts == most_cuts) return prove_halves(polygon, active);
  return prove_rest(polygon, best, active, origin);
}

// The foot of the inner place that lies most clearly before the polygon, if any.
std::optional<glm::dvec3> NearProof::find_inner(const Polygon& polygon, Active active) const {
  double clearest = 0.5 * level_;
  std::optional<glm::dvec3> found;
  for (std::size_t i = active.inner_begin; i < active.inner_end; ++i) {
    const double height = glm::dot(inner_[i] - polygon.corners[0], normal_);
    if (!(std::abs(height) <= limits_.most)) continue;
    const glm::dvec3 foot = inner_[i] - height * normal_;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < polygon.count && least > clearest; ++k) {
      const glm::dvec3 side = polygon.corners[(k + 1) % polygon.count] - polygon.corners[k];
      const double area = glm::dot(glm::cross(side, foot - polygon.corners[k]), normal_), length = glm::length(side);
      if (length > 0) least = std::min(least, area / length);
    }
    if (least > clearest && least < std::numeric_limits<double>::infinity()) clearest = least, found = foot;
  }
  return found;
}

bool NearProof::prove_around(const Polygon& polygon, const glm::dvec3& middle, Active active) {
  for (std::size_t i = 0; i < polygon.count; ++i) {
    Polygon part;
    part.add(middle);
    part.add(polygon.corners[i]);
    part.add(polygon.corners[(i + 1) % polygon.count]);
    if (!prove(part, active, {})) return false;
  }
  return true;
}

// Gives up where no side is longer than rounding.
bool NearProof::prove_halves(const Polygon& polygon, Active active) {
  if (!(polygon.side_length(polygon.longest_side()) > smallest_bound)) return false;
  const auto [first, second] = polygon.halves();
  return prove(first, active, {}) && prove(second, active, {});
}

// Proves one polygon for each run of corners that are not near the best target.
bool NearProof::prove_rest(const Polygon& polygon, const Best& best, Active active, const Origin& origin) {
  note_used(best.target);
  const double bound = targets_[best.target].bound, level = level_, slack = level - bound;
  const std::size_t n = polygon.count;
  const auto is_near = [&](std::size_t i) { return best.distances[i % n] + bound <= level; };
  std::size_t first = 0;
  while (!is_near(first)) ++first;
  for (std::size_t i = first; i < first + n; ++i) {
    if (!is_near(i) || is_near(i + 1)) continue;
    Polygon rest;
    rest.add(last_near(polygon.corners[i % n], polygon.corners[(i + 1) % n], best.target, slack));
    std::size_t k = i + 1;
    for (; !is_near(k); ++k) rest.add(polygon.corners[k % n]);
    rest.add(last_near(polygon.corners[k % n], polygon.corners[(k - 1) % n], best.target, slack));
    if (!prove(rest, active, {origin.cuts + 1, best.target})) return false;
  }
  return true;
}

// Whether the target that is nearest to the middle of a polygon is near the whole.
bool NearProof::nearest_covers(const Polygon& polygon, Active active) {
  glm::dvec3 middle{0.0};
  for (std::size_t i = 0; i < polygon.count; ++i) middle += polygon.corners[i] / static_cast<double>(polygon.count);
  double least = level_;
  std::uint32_t nearest = no_index;
  for (std::size_t k = active.begin; k < active.end; ++k) {
    const NearTarget& target = targets_[active_[k]];
    if (least_distance(middle, target) > least) continue;
    if (const double far = distance(middle, active_[k]) + target.bound; far <= least) least = far, nearest = active_[k];
  }
  if (nearest == no_index) return false;
  for (std::size_t i = 0; i < polygon.count; ++i)
    if (!(distance(polygon.corners[i], nearest) + targets_[nearest].bound <= level_)) return false;
  note_used(nearest);
  return true;
}

NearProof::Best NearProof::find_best(const Polygon& polygon, Active active, std::uint32_t but, double& need) {
  Best best;
  Distances least;
  least.fill(std::numeric_limits<double>::infinity());
  for (std::size_t k = active.begin; k < active.end; ++k) {
    const std::uint32_t target = active_[k];
    const double bound = targets_[target].bound;
    Distances distances{};
    std::size_t covered = 0;
    for (std::size_t i = 0; i < polygon.count; ++i) {
      const double lowest = least_distance(polygon.corners[i], targets_[target]);
      const bool is_plainly_far = lowest > level_ && lowest >= least[i];
      distances[i] = is_plainly_far ? lowest - bound : distance(polygon.corners[i], target);
      least[i] = std::min(least[i], distances[i] + bound);
      if (distances[i] + bound <= level_) ++covered;
    }
    if (covered <= best.covered || (target == but && covered < polygon.count)) continue;
    best = {target, covered, distances};
    if (covered == polygon.count) break;
  }
  need = best.covered == polygon.count
             ? 0
             : *std::max_element(least.begin(), least.begin() + static_cast<std::ptrdiff_t>(polygon.count));
  return best;
}

bool NearProof::raise_to(double need) {
  constexpr double further = 1.25;
  if (!(need <= limits_.most)) return false;
  level_ = std::min(limits_.most, further * need);
  return true;
}

bool NearProof::raise_further() {
  if (level_ >= limits_.most) return false;
  level_ = std::min(limits_.most, 3 * level_ + limits_.most / 1024);
  pieces_ = 1;
  return true;
}

double NearProof::distance(const glm::dvec3& p, std::span<const NearTarget> targets, double most) {
  double least = std::numeric_limits<double>::infinity();
  for (const NearTarget& target : targets) {
    if (least <= most) break;
    if (are_apart({p, p}, target.box, most)) continue;
    ++looks_;
    least = std::min(least, distance_to_triangle(target, p) + target.bound);
  }
  return least;
}

double NearProof::distance(const glm::dvec3& p, std::uint32_t target) {
  ++looks_;
  return distance_to_triangle(targets_[target], p);
}

// Goes back from b by Newton's steps. What is convex is never less than its tangent, so that they do not go too far.
glm::dvec3 NearProof::last_near(const glm::dvec3& a, const glm::dvec3& b, std::uint32_t target, double slack) {
  constexpr double share = 0.9;
  const auto& [c0, c1, c2] = targets_[target].corners;
  double far = 1;  // a share of the way
  for (int step = 0; step < 40; ++step) {
    const glm::dvec3 at = a + far * (b - a), way = way_from_triangle(c0, c1, c2, at);
    ++looks_;
    const double length = glm::length(way);
    if (length <= slack) return at;
    const double slope = glm::dot(way, b - a) / length, next = far - (length - share * slack) / slope;
    if (!(next > 0 && next < far)) return a;
    far = next;
  }
  return a;
}

void NearProof::note_used(std::uint32_t target) {
  if (std::find(used_.begin(), used_.end(), target) == used_.end()) used_.push_back(target);
}

}  // namespace ryosen
