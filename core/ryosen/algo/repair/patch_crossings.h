// Whether patches for holes cross the surface, themselves or each other.
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "ryosen/algo/repair/hole_loop.h"
#include "ryosen/base/progress.h"

namespace ryosen {

struct PlannedPatch {
  HoleLoop hole;
  HolePatch patch;
};

struct PatchCrossings {
  std::vector<bool> crosses;  // by patch: whether it crosses the surface or itself
  std::vector<Face> crossed;  // by patch: the lowest face of the surface that it crosses, if any
  // Of the others, those that cross each other, the earlier one first; ascending, each once.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
};

// Exact on the stored doubles, in the sense of find_self_intersections, but for points at one place: where a surface
// touches itself there, so may a patch that has a corner there. Patches must have no degenerate triangles. O(n log n +
// pairs of overlapping boxes) in the patches and the faces near them, and O(log patches) for each other face. Not to be
// used when cancelled.
PatchCrossings find_patch_crossings(const Mesh& mesh, std::span<const PlannedPatch> patches, Progress& progress);

// The side of the loop at which a triangle of the patch lies on the face across it, as every patch in its plane does to
// the outer border of a flat sheet; none where none does. O(n), to be asked first.
std::optional<std::uint32_t> side_on_surroundings(const HoleLoop& hole, const HolePatch& patch);

}  // namespace ryosen
