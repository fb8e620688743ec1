// Bounds of how far a triangle lies from a surface, by laying the surface over it.
//
//      +-----------------+     Seen along its normal, each part of the triangle lies
//      |\   .'|    _.-'  |     before one triangle of the surface. A distance from one
//      | \.'  | _-'      |     triangle is convex: no point of a part is farther from it
//      +-----------------+     than the farthest corner of that part.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "ryosen/algo/simplify/near_proof.h"

namespace ryosen {

class NearOverlay {
 public:
  // No point of the triangle is farther from what counts than this, infinite where it is more than `most` or there are
  // too many parts. Conservative whatever the targets are, and little more than the largest distance where they are one
  // sheet before the triangle. Distances are rounded, by about 1e-16 of the largest coordinate.
  double bound(const TriangleCorners& triangle, std::span<const NearTarget> targets, double most);

  // So many distances from triangles were computed so far.
  std::uint64_t looks() const { return looks_; }

 private:
  static constexpr std::size_t most_corners = 12;
  using Part = NearPolygon<most_corners>;
  // The half of space on one side of a target's side, seen along the normal: where dot(inward, p - from) is not less
  // than 0, of length 1.
  struct Half {
    glm::dvec3 inward, from;
  };
  using Halves = std::array<Half, 3>;

  static Halves halves_before(const NearTarget& target, const glm::dvec3& normal);
  // Cuts a part in two, either of which may be empty; false where one would have too many corners.
  static bool cut(const Part& part, const Half& half, Part& within, Part& beyond);
  static bool is_apart(const Part& part, const Halves& halves);
  // Takes what lies before a target, near enough, out of the parts; false where it gives up.
  bool take_out(const NearTarget& target, const Halves& halves, double most);
  // Whether all parts that are left are near what counts.
  bool prove_rest(std::span<const NearTarget> targets, double most);
  double distance(const glm::dvec3& p, const NearTarget& target);
  // Or something that is more than what is enough.
  double farthest_corner(const Part& part, const NearTarget& target, double enough);

  std::vector<Part> parts_, rest_;
  double bound_ = 0;
  std::uint64_t looks_ = 0;
};

}  // namespace ryosen
