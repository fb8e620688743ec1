// Pairs of faces that meet where a mesh says that they do not.
//
// A face is the set of its triangles (geometry/triangulate.h), those whose corners lie exactly on a line left out. Two
// different faces meet elsewhere, if a triangle of one and a triangle of the other have a point in common that is
// neither a common corner of the two nor on a segment that is a side of both faces. Corners are common by the number of
// their point: copies of a point are one, two points at the same place are two (weld them). So touching counts, in a
// single point too: a corner that lies on a foreign face or edge (a T-junction), overlap within a plane, two faces folded
// over their common edge, and two triangles on the same three points. Degenerate faces and faces with a coordinate that
// is not finite meet nothing.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "core/mesh/mesh.h"

namespace ryosen {

struct FacePair {
  Face first, second;  // first < second
  friend auto operator<=>(const FacePair&, const FacePair&) = default;
};

struct SelfIntersections {
  std::vector<FacePair> pairs;  // ascending, each once
  bool is_all = true;           // false: there were more than asked for, and these are some
};

// All such pairs, or some if there are more than `most`: n copies of a triangle make n^2 / 2. Decided exactly on the
// stored doubles. O(n log n + pairs of overlapping boxes); the boxes of fans, cones and slivers aslant do not overlap
// (overlap_tree.h), those of many faces on one edge do. threads: 0 takes as many as pay. The result does not depend on it, nor, if it is all, on the order
// of faces and corners.
SelfIntersections find_self_intersections(const Mesh& mesh, std::size_t most = std::numeric_limits<std::size_t>::max(),
                                          unsigned threads = 0);

// The faces that occur in pairs, ascending, each once.
std::vector<Face> faces_of(const std::vector<FacePair>& pairs);

}  // namespace ryosen
