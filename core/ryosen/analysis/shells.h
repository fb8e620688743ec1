// The closed shells of a mesh: how each is turned, which of them meet, and how deep each lies inside the others.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "ryosen/analysis/components.h"

namespace ryosen {

struct Shell {
  Face first;               // the lowest face
  int turned = 0;           // +1: faces look outwards, -1: inwards, 0: no volume; exact (volume_sign.h)
  std::uint32_t depth = 0;  // how many other shells it lies inside of
};

struct Shells {
  std::vector<Shell> all;  // by lowest face
  // Faces of two shells that have a point in common, touching counts; the depths are not known then. Where a shell has
  // no volume neither is.
  std::optional<std::pair<Face, Face>> meeting;
};

// The mesh must be manifold, closed, consistently oriented and finite. Triangle intersections and ray crossings are
// exact. Self-intersections of one shell are not searched (self_intersections.h). O(n log n), plus pairs of shells of
// which only the box of one encloses the other, plus pairs of triangles with overlapping boxes among siblings (shells
// with the same innermost shell around them) and between a shell and the innermost one around it.
Shells find_shells(Neighbourhood& around);

// The same of these components alone, each of them closed and finite: at every edge on points as many of its faces run
// one way as the other. Faces of no component (no_index) count for nothing. The depths are known where shells meet,
// too: those that meet, one by one or through others, are one body, and the depth of its shells is the number of bodies
// around it. A shell without volume is not turned, and encloses nothing. `all` is by component. Where shells meet the
// cost has pairs of triangles of any two shells with overlapping boxes.
Shells nest_shells(const Mesh& mesh, FaceComponents components);

}  // namespace ryosen
