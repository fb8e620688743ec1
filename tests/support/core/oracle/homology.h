// Parts and handles of a complex by linear algebra over the field of two elements: the ranks of its boundary matrices.
#pragma once

#include <optional>

#include "tests/support/core/oracle/complex.h"

namespace ryosen::oracle {

struct Homology {
  int parts = 0;             // what hangs together by edges, faces and points; a free point is one
  bool is_surface = false;   // no third face on an edge, one fan of faces at a point, faces that can be turned to agree
  std::optional<int> genus;  // handles of all parts; for a surface without wires
};

// Of a complex whose vertices are points (on_points()). O(n^3) with words of bits: for small meshes.
Homology homology_of(const Complex& points);

}  // namespace ryosen::oracle
