// The rims of holes, and the kinds of patches that they get.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "ryosen/algo/repair/find_holes.h"
#include "ryosen/algo/repair/hole_loop.h"
#include "ryosen/algo/repair/plan_patch.h"

namespace ryosen {

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
