// Planning a patch for a hole, in one of several ways.
#pragma once

#include <span>

#include "core/algo/repair/find_holes.h"
#include "core/algo/repair/hole_triangles.h"

namespace ryosen {

struct WayToFill {
  HoleTriangles (*triangulate)(const HoleLoop&, Progress&);
  bool refines, fairs;
};

// In the order in which they are to be tried.
std::span<const WayToFill> ways_to_fill();

// Makes a patch for the hole without degenerate triangles from `base`, what the way's triangulate() gives; `filled`, or
// why there is none. With `snaps_to_floats` new places are floats. Not to be used when cancelled.
WhyOpen plan_patch(const WayToFill& way, const HoleTriangles& base, const HoleLoop& hole, bool snaps_to_floats,
                   HolePatch& patch, Progress& progress);

}  // namespace ryosen
