// Proofs that a triangle lies near a surface.
//
// A distance from one triangle is convex: what lies between points that are near it is near it as well. So a polygon
// some of whose corners are near a triangle loses all that lies between these corners and the last near points of the
// sides that leave them, and what remains is proved by other triangles. Where a vertex of the surface lies before the
// middle of a polygon, that is parted there first, since no triangle at that vertex is near the whole.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "ryosen/algo/simplify/near_polygon.h"
#include "ryosen/geometry/box.h"
#include "ryosen/mesh/triangle_corners.h"

namespace ryosen {

// A triangle of the surface, no point of which is farther than the bound from what counts.
struct NearTarget {
  TriangleCorners corners;
  double bound = 0;
  Box box = Box();
};

NearTarget target_of(const TriangleCorners& corners, double bound);
// Without its bound.
double distance_to_triangle(const NearTarget& target, const glm::dvec3& p);
// Whether two boxes are farther apart than that along an axis.
bool are_apart(const Box& a, const Box& b, double gap);

class NearProof {
 public:
  struct Limits {
    double most = 0;         // no point may be farther
    std::size_t pieces = 0;  // the bound goes up, or the proof gives up, after so many
    double start = 0;        // where the bound begins
  };

  // Polygons are parted no deeper than this, so that the stack stays small. Proofs that succeed need about 100.
  static constexpr std::size_t most_depth = 128;

  // Whether no point of a triangle is farther from what counts than limits.most. Conservative: false where it gave up.
  // All distances are rounded, by about 1e-16 of the largest coordinate.
  // `inner`: places of vertices around which there are targets.
  bool prove(const TriangleCorners& triangle, std::span<const NearTarget> targets, std::span<const glm::dvec3> inner,
             const Limits& limits);

  // How far a point is from what counts by the nearest target, or by the first one by which it is no farther than most;
  // infinite perhaps where it is farther.
  double distance(const glm::dvec3& p, std::span<const NearTarget> targets, double most);

  // After a proof: no point is farther than this.
  double bound() const { return level_; }
  // The targets that the proof has used.
  std::span<const std::uint32_t> used() const { return used_; }
  // So many distances from triangles were computed so far.
  std::uint64_t looks() const { return looks_; }
  // The depth of the deepest polygon of the last proof.
  std::size_t deepest() const { return deepest_; }

 private:
  static constexpr std::size_t most_corners = 8;
  using Polygon = NearPolygon<most_corners>;
  // How far the corners of a polygon are from one target.
  using Distances = std::array<double, most_corners>;
  struct Best {
    std::uint32_t target = no_index;
    std::size_t covered = 0;
    Distances distances{};
  };

  // Targets and inner places in parts of active_ and inner_.
  struct Active {
    std::size_t begin, end, inner_begin, inner_end;
  };
  // A polygon is the rest of another one after so many cuts, the last one by this target.
  struct Origin {
    unsigned cuts = 0;
    std::uint32_t cut_by = no_index;
  };
  bool prove(const Polygon& polygon, Active among, const Origin& origin);
  bool prove_near(const Polygon& polygon, Active active, const Origin& origin);
  bool prove_around(const Polygon& polygon, const glm::dvec3& middle, Active active);
  bool prove_halves(const Polygon& polygon, Active active);
  bool prove_rest(const Polygon& polygon, const Best& best, Active active, const Origin& origin);
  // Where to part a polygon.
  std::optional<glm::dvec3> find_inner(const Polygon& polygon, Active active) const;
  bool nearest_covers(const Polygon& polygon, Active active);
  // The target that is near all corners, or else of those but one the target that is near the most. `need`: how far the
  // farthest corner is from what counts.
  Best find_best(const Polygon& polygon, Active active, std::uint32_t but, double& need);
  // Lets the bound be larger, where it may be.
  bool raise_to(double need);
  bool raise_further();
  double distance(const glm::dvec3& p, std::uint32_t target);
  // The last point from a to b, or one shortly before, that is near the target.
  glm::dvec3 last_near(const glm::dvec3& a, const glm::dvec3& b, std::uint32_t target, double slack);
  void note_used(std::uint32_t target);

  std::span<const NearTarget> targets_;
  Limits limits_;
  double level_ = 0;
  std::size_t pieces_ = 0, depth_ = 0, deepest_ = 0;
  glm::dvec3 normal_{0.0};             // of the triangle, of length 1
  std::vector<std::uint32_t> active_;  // a stack: the targets near the polygon that is being proved
  std::vector<glm::dvec3> inner_;      // another one
  std::vector<std::uint32_t> used_;
  std::uint64_t looks_ = 0;
};

}  // namespace ryosen
