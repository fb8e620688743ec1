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
  int turned = 0;           // +1: faces look outwards, -1: inwards, 0: no volume that rounding would leave a sign to
  std::uint32_t depth = 0;  // how many other shells it lies inside of
};

struct Shells {
  std::vector<Shell> all;  // by lowest face
  // Faces of two shells that have a point in common, touching counts; the depths are not known then.
  std::optional<std::pair<Face, Face>> meeting;
};

// The mesh must be manifold, closed, with faces that agree, and finite. Which triangles meet and which a ray passes is
// decided exactly; only shells whose boxes overlap are looked at. Meetings within one shell are not searched
// (self_intersections.h). O(n log n), and the triangles of different shells whose boxes overlap.
Shells find_shells(Neighbourhood& around);

}  // namespace ryosen
