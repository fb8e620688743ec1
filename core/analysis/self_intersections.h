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

#include <vector>

#include "core/mesh/mesh.h"

namespace ryosen {

struct FacePair {
  Face first, second;  // first < second
  friend auto operator<=>(const FacePair&, const FacePair&) = default;
};

// All such pairs, ascending, each once. Decided exactly on the stored doubles. O(n log n + pairs of overlapping boxes).
// threads: 0 takes as many as pay. The result does not depend on it, nor on the order of faces and corners.
std::vector<FacePair> find_self_intersections(const Mesh& mesh, unsigned threads = 0);

// The faces that occur in pairs, ascending, each once.
std::vector<Face> faces_of(const std::vector<FacePair>& pairs);

}  // namespace ryosen
