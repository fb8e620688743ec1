#include "ryosen/hull/antipodes.h"

#include <algorithm>

#include "ryosen/base/handle.h"

namespace ryosen::hull {

HullLinks::HullLinks(const ConvexHull& hull) : hull_(hull) {
  const auto count = static_cast<std::uint32_t>(hull.corners.size());
  next_.resize(count);
  facet_.resize(count);
  for (std::uint32_t f = 0; f < hull.facet_count(); ++f)
    for (std::uint32_t k = hull.facet_offsets[f]; k < hull.facet_offsets[f + 1]; ++k) {
      next_[k] = k + 1 < hull.facet_offsets[f + 1] ? k + 1 : hull.facet_offsets[f];
      facet_[k] = f;
    }
  // The sides by the point from which they run, so that the twin of one is among few.
  const std::size_t points = hull.vertices.empty() ? 0 : hull.vertices.back() + std::size_t{1};
  side_from_.assign(points, no_index);
  std::vector<std::uint32_t> another(count), before(count);  // that runs from the same point; in the same facet
  for (std::uint32_t k = count; k-- > 0;) {
    another[k] = side_from_[hull.corners[k]];
    side_from_[hull.corners[k]] = k;
    before[next_[k]] = k;
  }
  twin_.assign(count, no_index);
  std::vector<std::uint32_t> side_to(points, no_index);  // from the point that is looked at
  for (const std::uint32_t p : hull.vertices) {
    for (std::uint32_t k = side_from_[p]; k != no_index; k = another[k]) side_to[to(k)] = k;
    for (std::uint32_t k = side_from_[p]; k != no_index; k = another[k]) twin_[before[k]] = side_to[from(before[k])];
  }
}

Antipodes::Antipodes(std::span<const glm::dvec3> points, const ConvexHull& hull, Progress& progress)
    : points_(points), hull_(hull), links_(hull), lowest_(hull.facet_count(), no_index) {
  mark_.resize(hull.vertices.back() + std::size_t{1}, 0);
  // From facet to facet beside it, so that what is lowest for one is near what is for the next.
  std::vector<std::uint32_t> waiting{0};
  lowest_[0] = climb_down(0, links_.from(0));
  for (std::size_t at = 0; at < waiting.size(); ++at) {
    if (at % 1024 == 0 && !progress.go_on(at, hull.facet_count())) return;
    const std::uint32_t facet = waiting[at];
    for (std::uint32_t k = hull.facet_offsets[facet]; k < hull.facet_offsets[facet + 1]; ++k) {
      const std::uint32_t beside = links_.facet(links_.twin(k));
      if (lowest_[beside] != no_index) continue;
      lowest_[beside] = climb_down(beside, lowest_[facet]);
      waiting.push_back(beside);
    }
  }
}

int Antipodes::height_sign(std::uint32_t facet, std::uint32_t p, std::uint32_t q) const {
  const auto c = hull_.facet(facet);
  return determinant_sign({points_[c[0]], points_[c[1]]}, {points_[c[0]], points_[c[2]]}, {points_[p], points_[q]});
}

// On a convex surface a point without lower neighbours is lowest.
std::uint32_t Antipodes::climb_down(std::uint32_t facet, std::uint32_t from) const {
  for (std::uint32_t at = from;;) {
    const std::uint32_t first = links_.side_from(at);
    std::uint32_t side = first;
    while (height_sign(facet, at, links_.to(side)) >= 0) {
      side = links_.next_from(side);
      if (side == first) return at;
    }
    at = links_.to(side);
  }
}

void Antipodes::reach(std::uint32_t point) {
  if (mark_[point] == search_) return;
  mark_[point] = search_;
  reached_.push_back(point);
}

const std::vector<std::uint32_t>& Antipodes::all_lowest(std::uint32_t facet) {
  ++search_;
  reached_.clear();
  reach(lowest_[facet]);
  for (std::size_t at = 0; at < reached_.size(); ++at) {
    const std::uint32_t first = links_.side_from(reached_[at]);
    std::uint32_t side = first;
    do {
      if (height_sign(facet, reached_[at], links_.to(side)) == 0) reach(links_.to(side));
      side = links_.next_from(side);
    } while (side != first);
  }
  return reached_;
}

// While a plane turns about the edge from one of its facets to the other, the parallel plane on the other side rolls
// from point to point, each time over an edge.
const std::vector<std::uint32_t>& Antipodes::edges_opposite(std::uint32_t side) {
  edges_.clear();
  const std::uint32_t start = lowest_[links_.facet(side)];
  if (start == lowest_[links_.facet(links_.twin(side))]) return edges_;
  ++search_;
  reached_.clear();
  reach(start);
  for (std::size_t at = 0; at < reached_.size(); ++at) {
    const std::uint32_t first = links_.side_from(reached_[at]);
    std::uint32_t other = first;
    do {
      if (is_opposite(side, other)) {
        reach(links_.to(other));
        edges_.push_back(std::min(other, links_.twin(other)));
      }
      other = links_.next_from(other);
    } while (other != first);
  }
  std::sort(edges_.begin(), edges_.end());
  edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
  return edges_;
}

// The normal of planes along both edges is their cross product, or its opposite: it must point out of the hull at the
// one edge, so not towards the facets there, and into it at the other.
bool Antipodes::is_opposite(std::uint32_t side, std::uint32_t other) const {
  const Difference e = edge(side), f = edge(other);
  const auto towards = [&](std::uint32_t at, std::uint32_t apex_of) {
    return determinant_sign(e, f, {points_[links_.from(at)], points_[links_.apex(apex_of)]});
  };
  const int left = towards(side, side), right = towards(side, links_.twin(side));
  if (left == 0 && right == 0) return has_parallel_planes(side, other);
  if (left * right < 0) return false;
  const int sign = left != 0 ? -left : -right;
  return sign * towards(other, other) >= 0 && sign * towards(other, links_.twin(other)) >= 0;
}

// Of parallel edges: whether the plane of a facet at one of them may be moved to the other.
bool Antipodes::has_parallel_planes(std::uint32_t side, std::uint32_t other) const {
  const auto has = [&](std::uint32_t at, std::uint32_t opposite) {
    const std::uint32_t c = links_.from(opposite), facet = links_.facet(at);
    return height_sign(facet, c, links_.apex(opposite)) >= 0 &&
           height_sign(facet, c, links_.apex(links_.twin(opposite))) >= 0;
  };
  return has(side, other) || has(links_.twin(side), other) || has(other, side) || has(links_.twin(other), side);
}

}  // namespace ryosen::hull
