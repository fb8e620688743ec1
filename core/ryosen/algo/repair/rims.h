// The rims of holes: the planes in which they lie but for rounding, those that are congruent, so that they are filled
// alike, the outer borders of flat sheets, and the kinds of patches that they get.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "ryosen/algo/repair/find_holes.h"
#include "ryosen/geometry/box.h"

namespace ryosen {

glm::dvec3 mean_of(std::span<const glm::dvec3> places);
// Whether all finite places are floats, as those of a file of floats are.
bool are_all_floats(std::span<const glm::dvec3> places);

class RimPlane {
 public:
  // None where the rim leaves the plane that fits it by more than 4 units in the last place, or has no area. The unit
  // is that of `largest`, the absolutely largest coordinate of the mesh, in single precision where the rim holds
  // floats, else in double. `holds_floats` says whether it does; where that is not known, it does where all its
  // coordinates are floats, or where all are decimals of floats and half of them no floats, as in a text that floats
  // were printed to. Corners are finite. O(n).
  static std::optional<RimPlane> of(std::span<const glm::dvec3> rim, double largest,
                                    std::optional<bool> holds_floats = {});

  // The place in the plane nearest to p, a float where the rim has floats; a coordinate that all corners share is
  // exact.
  glm::dvec3 nearest(const glm::dvec3& p) const;

  // The distance of p from the plane.
  double distance(const glm::dvec3& p) const;

  // How far from the plane corners of the rim may lie.
  double tolerance() const;

  // Unit; corners run counter-clockwise seen from its tip.
  const glm::dvec3& normal() const { return normal_; }

 private:
  int exponent_ = 0;  // coordinates times 2^-exponent_ are at most 2
  bool is_single_ = false;
  bool snaps_ = false;      // to floats
  glm::dvec3 normal_{0.0};  // unit
  glm::dvec3 at_{0.0};      // a point of the plane, scaled
  Box box_;                 // of the rim
};

// Corner i of this rim is corner shift + i of rim `as`, or shift - i where one is the mirror image of the other.
struct EqualRim {
  std::uint32_t as = 0, shift = 0;
  bool is_mirrored = false;

  std::uint32_t corner_of(std::uint32_t i, std::uint32_t size) const {
    return is_mirrored ? (shift + size - i) % size : (shift + i) % size;
  }
};

// Finds for each rim an earlier one that it equals but for `rounding` and a millionth part of its size or so; none
// where there is none, and for rims of collinear corners. O(n log n); of symmetrical rims a few turns are tried.
std::vector<std::optional<EqualRim>> find_equal_rims(std::span<const std::vector<glm::dvec3>> rims, double rounding);

// The patch of the rim `equal.as`, moved to the hole: as many vertices and triangles in the same arrangement.
HolePatch patch_like(const HolePatch& other, const EqualRim& equal, const HoleLoop& hole);

// The kind of patch for a hole.
struct PatchStyle {
  bool fairs = false;
  std::optional<RimPlane> plane;  // in which its vertices are to lie
  bool snaps_to_floats = false;   // new places are floats
  bool may_cross = false;
};

// Places and planes of the rims to be tried, by hole.
struct Rims {
  std::vector<std::vector<glm::dvec3>> places;
  std::vector<std::optional<RimPlane>> planes;  // in which the rims lie, whatever the shape
  std::vector<PatchStyle> styles;
  std::vector<std::optional<EqualRim>> equal;
  std::vector<bool> is_like;  // whether other rims equal it
};

// `shape` is one of auto, flat, fair. `holds_floats` says whether the file has coordinates of type float
// (AlgorithmInput); where nothing is known the numbers are judged.
Rims read_rims(const Mesh& mesh, std::span<const Hole> holes, std::string_view shape, std::optional<bool> holds_floats);

// Gives WhyOpen::flat_sheet to the holes that are to be tried and are the outer border of a sheet: the faces that are
// joined to its rim over edges lie in the plane of the rim like the rim itself, and a patch would face the other way,
// so that nothing would be enclosed. O(faces).
void tell_flat_sheets(const Mesh& mesh, const Rims& rims, std::vector<Hole>& holes);

}  // namespace ryosen
