// Choosing among planned patches those that may be inserted together, and whether they cross the surface, themselves or
// each other.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "ryosen/algo/repair/find_holes.h"

namespace ryosen {

struct PlannedPatch {
  HoleLoop hole;
  HolePatch patch;
};

// The side of the loop at which a triangle of the patch lies on the face across it, as every patch in its plane does to
// the outer border of a flat sheet; none where none does. O(n), to be asked first.
std::optional<std::uint32_t> side_on_surroundings(const HoleLoop& hole, const HolePatch& patch);

// Rules by which patches are taken.
enum class Takes {
  clear,          // those that cross nothing, and no other one of them
  first,          // of those that exclude each other the first
  crossing,       // also those that cross the surface or each other
  self_crossing,  // all
};

struct PatchChoice {
  std::vector<WhyOpen> cause;   // by patch: `filled` where it is taken
  std::vector<Face> crossed;    // by patch: the lowest face of the surface that it crosses, if any
  std::vector<bool> conflicts;  // by patch: whether it and another one exclude each other
};
// What crosses is told exactly on the stored doubles, in the sense of find_self_intersections, but for points at one
// place: where a surface touches itself there, so may a patch that has a corner there. Patches must have no degenerate
// triangles. O(n log n + pairs of overlapping boxes) in the patches and the faces near them, and O(log patches) for
// each other face. Not to be used when cancelled.
PatchChoice choose_patches(const Mesh& mesh, std::span<const PlannedPatch> planned, Takes takes, Progress& progress);

}  // namespace ryosen
