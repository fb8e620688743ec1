// Points that slide along the curve that a boundary was: each towards the middle of its neighbours, by the way on the
// curve.
//
//      held --- p --------- q --- held          the curve is the chain of edges between points that are held, or
//           t=0   ->   <-                        a whole loop; the length t from its beginning tells where a point is
#pragma once

#include <cstdint>
#include <vector>

#include "ryosen/algo/smooth/laplacian.h"

namespace ryosen::smooth {

class BoundarySlide {
 public:
  struct Point {
    std::uint32_t point, before, after;  // and its neighbours on the boundary
    double share;                        // of the way
  };

  // `places` as the curve is; each point is the neighbour of those that slide beside it. O(n log n).
  BoundarySlide(std::vector<Point> points, const Places& places);

  // Moves them by a share of the way, those between which they lie being where they were. O(n log n).
  void step(double strength, Places& places);

  const std::vector<Point>& points() const { return points_; }

 private:
  struct Curve {
    std::vector<glm::dvec3> corners;
    std::vector<double> lengths;      // from the beginning, to each corner
    std::vector<std::size_t> points;  // in their order, without those that are held
    bool is_loop = false;
  };

  void follow(std::size_t first, std::vector<std::uint8_t>& is_known, const std::vector<std::size_t>& slot_of,
              const Places& places);
  glm::dvec3 place_at(const Curve& curve, double t) const;

  std::vector<Point> points_;
  std::vector<double> at_;  // by point
  std::vector<Curve> curves_;
};

}  // namespace ryosen::smooth
