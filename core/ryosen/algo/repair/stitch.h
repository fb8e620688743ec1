// Repair: puts vertices into the edges that they lie on.
#pragma once

#include "ryosen/algo/algorithm.h"

namespace ryosen {

// Stitches T-junctions, points that lie on a side of a face which has no other face: the side gets a vertex at the
// point's place, which is welded to the point together with the parts of the side on both sides of it
// (weld_near_points). A triangle is cut in two, another face gets a corner. A point of several fans becomes a point for
// each fan first. A point goes in only where this joins one of these parts to another side, and, where it lies beside
// the edge, turns no triangle and leaves none without area.
//
//      +-----------+            +-----------+
//      |           |            |           |        the point p of the two faces below lies on a side of the one above
//      +-----------+     =>     +-----p-----+
//      +-----p-----+            |     |     |
//      |     |     |            +-----+-----+
//      +-----+-----+
//
// `distance` 0 stitches where points lie exactly on an edge, by exact predicates; the surface keeps its shape.
// Otherwise `crossings` counts the pairs of faces that meet afterwards and did not before. Stitching again does
// nothing. Cost: a few rounds of O(n log n), and with a distance two searches for self-intersections.
AlgorithmResult stitch(Edit& edit, const AlgorithmInput& input, Progress& progress);

}  // namespace ryosen
