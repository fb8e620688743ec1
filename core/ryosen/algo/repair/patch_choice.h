// Choosing among planned patches those that may be inserted together.
#pragma once

#include <span>
#include <vector>

#include "ryosen/algo/repair/find_holes.h"
#include "ryosen/algo/repair/patch_crossings.h"

namespace ryosen {

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
// The cost of find_patch_crossings. Not to be used when cancelled.
PatchChoice choose_patches(const Mesh& mesh, std::span<const PlannedPatch> planned, Takes takes, Progress& progress);

}  // namespace ryosen
