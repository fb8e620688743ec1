// The closed shells of a mesh: how each is turned, which of them meet, and how deep each lies inside the others.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/analysis/components.h"

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

}  // namespace ryosen
