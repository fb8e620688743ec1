// Planning a patch for a hole, in one of several ways.
#pragma once

#include <span>

#include "ryosen/algo/repair/hole_triangles.h"
#include "ryosen/algo/repair/rims.h"

namespace ryosen {

enum class Fineness : std::uint8_t {
  bare,  // triangles between the corners of the rim, and at most one vertex in the middle
  even,  // refined on these triangles, and new vertices moved towards the middle of their neighbours
  fair,  // and then to where the patch bends least
};

struct WayToFill {
  HoleTriangles (*triangulate)(const HoleLoop&, Progress&);
  Fineness fineness;
};

// Returns the ways in the order in which they are to be tried.
std::span<const WayToFill> ways_to_fill(const PatchStyle& style);

struct PlanResult {
  WhyOpen cause = WhyOpen::filled;  // or why there is no patch
  Halfedge crossed = {};            // where it crosses the face across a side of the loop: that side
};

// Makes a patch for the hole from `base`, what the way's triangulate() gives: its vertices and triangles, to be
// finished. Not to be used when cancelled.
PlanResult arrange_patch(const WayToFill& way, const HoleTriangles& base, const HoleLoop& hole, const PatchStyle& style,
                         HolePatch& patch, Progress& progress);

// Gives an arranged patch, or one moved from an equal rim (rims.h), its final places. No vertex comes, and no
// triangle is degenerate.
PlanResult finish_patch(const WayToFill& way, const HoleLoop& hole, const PatchStyle& style, HolePatch& patch,
                        Progress& progress);

}  // namespace ryosen
