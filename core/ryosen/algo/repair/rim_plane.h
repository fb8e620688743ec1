// The plane in which the rim of a hole lies but for rounding.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>

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

}  // namespace ryosen
