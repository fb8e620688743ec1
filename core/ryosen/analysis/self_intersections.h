// Self-intersections: pairs of faces that meet other than at shared corners and edges.
//
// A face is the set of its triangles (geometry/triangulate.h), without those whose corners are exactly collinear. Two
// faces intersect if a triangle of one and a triangle of the other have a common point that is neither a shared corner
// nor on a segment that is a side of both faces. Corners are shared by point number: copies of a point are the same,
// two points at the same position are not (weld them). Touching counts, even in a single point: a corner on another
// face or edge (a T-junction), coplanar overlap, two faces folded over their common edge, and two triangles on the same
// three points. Degenerate faces and faces with a non-finite coordinate never intersect.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "ryosen/base/progress.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

struct FacePair {
  Face first, second;  // first < second
  friend auto operator<=>(const FacePair&, const FacePair&) = default;
};

struct SelfIntersections {
  std::vector<FacePair> pairs;  // ascending, each once: all, or `most` of them
  std::size_t count = 0;        // of all pairs
  std::vector<Face> faces;      // of all pairs, ascending, each once

  bool is_all() const { return pairs.size() == count; }
};

// All such pairs. Of more than `most` that many are kept and the others only counted: n copies of a triangle make
// n^2 / 2. Exact on the stored doubles. O(n log n + pairs of overlapping boxes); fans, cones and oblique slivers
// produce few overlaps (overlap_tree.h), many faces at one edge produce all pairs. Memory: O(n) and the pairs kept.
// threads: 0 chooses automatically. The result does not depend on it nor, if complete, on the order of faces and
// corners.
SelfIntersections find_self_intersections(const Mesh& mesh, std::size_t most = std::numeric_limits<std::size_t>::max(),
                                          unsigned threads = 0);

// The same, or none where it was cancelled meanwhile.
std::optional<SelfIntersections> find_self_intersections(const Mesh& mesh, std::size_t most, unsigned threads,
                                                         Progress& progress);

// The same while there are not too many: with more than `most` pairs it stops soon, and only says so, by none of them
// and a count above `most`. O(n log n + boxes that overlap until then), a few 100,000 and `most` of those that meet.
std::optional<SelfIntersections> find_few_self_intersections(const Mesh& mesh, std::size_t most, Progress& progress);

// The faces that occur in the pairs, ascending, each once.
std::vector<Face> faces_of(const std::vector<FacePair>& pairs);

}  // namespace ryosen
