#include "ryosen/analysis/measure/cell_bound.h"

#include <algorithm>
#include <limits>

namespace ryosen {

namespace {

// Distances from the triangles that are nearest to the corners of a cell.
class CellBound {
 public:
  CellBound(const TriangleTree& to, const FarthestCell& cell, double wanted) : to_(to), cell_(cell), wanted_(wanted) {}

  // A distance from one triangle is convex, so that it is nowhere larger than at one of the corners.
  double from_one() {
    double least = unknown;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t t = cell_.near[i].triangle;
      if (cell_.is_repeated(i)) continue;
      double most = cell_.near[i].distance;
      for (std::size_t k = 0; k < 3; ++k)
        if (cell_.near[k].triangle != t) most = std::max(most, distance(cell_.corners[k], t));
      least = std::min(least, most);
    }
    return least;
  }

  // The cell in two parts, or three, each as far from the triangle that is nearest at its corner of the cell. Gives up
  // where that cannot be as little as wanted.
  double from_several() {
    for (std::size_t i = 0; i < 3; ++i)
      if (cell_.near[(i + 1) % 3].triangle == cell_.near[(i + 2) % 3].triangle) return from_two(i);
    return from_three();
  }

 private:
  static constexpr double unknown = std::numeric_limits<double>::infinity();

  // A point at which two triangles are about as far, and how far the farther one is.
  struct Cut {
    glm::dvec3 place{0.0};
    double distance = 0;
  };

  double distance(const glm::dvec3& p, std::uint32_t t) const { return without_rounding(to_.distance(p, t)); }

  // Between a place that is nearer to all of `here` than to `there` and one where that is the other way round. Ends
  // early where a distance that is wanted was reached, or cannot be.
  template <class Here>
  Cut cut(glm::dvec3 a, glm::dvec3 b, const Here& here, std::uint32_t there) const {
    Cut best{a, unknown};
    for (int step = 0; step < 48; ++step) {
      const glm::dvec3 middle = 0.5 * a + 0.5 * b;
      const double from_here = here(middle), from_there = distance(middle, there);
      const double farther = std::max(from_here, from_there);
      if (farther < best.distance) best = {middle, farther};
      if (farther <= wanted_ || std::min(from_here, from_there) > wanted_) return best;
      (from_here < from_there ? a : b) = middle;
    }
    return best;
  }
  // On the side between two corners.
  Cut cut_side(std::size_t i, std::size_t k) const {
    const std::uint32_t t = cell_.near[i].triangle;
    return cut(
        cell_.corners[i], cell_.corners[k], [&](const glm::dvec3& p) { return distance(p, t); },
        cell_.near[k].triangle);
  }

  double at_corners() const {
    return std::max({cell_.near[0].distance, cell_.near[1].distance, cell_.near[2].distance});
  }

  // Corner i has a triangle of its own, the two others have one together, which is that of i + 1.
  double from_two(std::size_t i) const {
    const std::size_t k = (i + 1) % 3, l = (i + 2) % 3;
    const double first = cut_side(i, k).distance;
    return first > wanted_ ? unknown : std::max({at_corners(), first, cut_side(i, l).distance});
  }

  // Cuts the three sides, and then the line on which the triangles of corners 0 and 1 are as far, where 2's is.
  double from_three() const {
    const Cut side = cut_side(0, 1), second = cut_side(1, 2), third = cut_side(2, 0);
    const double sides = std::max({at_corners(), side.distance, second.distance, third.distance});
    if (sides > wanted_) return unknown;
    const std::uint32_t t0 = cell_.near[0].triangle, t1 = cell_.near[1].triangle, t2 = cell_.near[2].triangle;
    const glm::dvec3& last = cell_.corners[2];
    const bool leaves_by_second = distance(last, t0) <= distance(last, t1);
    const auto from_one = [&](const glm::dvec3& p) { return distance(p, leaves_by_second ? t1 : t0); };
    const Cut end = cut(cell_.corners[leaves_by_second ? 1 : 0], last, from_one, leaves_by_second ? t0 : t1);
    const auto from_both = [&](const glm::dvec3& p) { return std::max(distance(p, t0), distance(p, t1)); };
    return std::max(sides, cut(side.place, end.place, from_both, t2).distance);
  }

  const TriangleTree& to_;
  const FarthestCell& cell_;
  const double wanted_;
};

}  // namespace

double bound_of(const TriangleTree& to, const FarthestCell& cell, double wanted) {
  CellBound bound(to, cell, wanted);
  const double of_one = bound.from_one();
  return of_one > wanted ? std::min(of_one, bound.from_several()) : of_one;
}

}  // namespace ryosen
