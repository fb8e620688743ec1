// What raising some faces on walls, or edges on quads, does to a list of points.
#pragma once

#include <vector>

#include "tests/support/core/oracle/complex.h"

namespace ryosen::oracle {

struct Extruded {
  Complex after;
  int points = 0;         // replaced by new ones, which are numbered from the end on
  int border_points = 0;  // those of them on the border
  int walls = 0;
};
// `points` is a list whose vertices are their points. The faces in the order in which they are named.
Extruded extruded(const Complex& points, const std::vector<int>& faces);

// Each side a -> b gets a quad, against it if it is one of a face, else along it in the place of a wire. New points are
// numbered from the end on, as the sides meet them.
Complex with_extruded_edges(const Complex& points, const std::vector<Pair>& sides);

// The faces, each of one loop, with the points from `old` on named in the order in which the faces meet them.
std::vector<Corners> faces_with_new_points_in_order(const Complex& complex, int old);

}  // namespace ryosen::oracle
