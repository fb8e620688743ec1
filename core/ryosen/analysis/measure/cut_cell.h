// Parts of a triangle whose distance from a surface is known better.
#pragma once

#include <array>
#include <cstddef>

#include "ryosen/analysis/measure/cell_bound.h"

namespace ryosen {

struct CellParts {
  std::array<FarthestCell, 3> cells;
  std::size_t count = 0;
  // Corners that the cell did not have, and how far they are.
  std::array<glm::dvec3, 2> places;
  std::array<double, 2> distances;
  std::size_t new_places = 0;
};

// Cuts a cell through a side of a triangle that lies below one of its corners and ends before another, at a right angle
// to the triangle: so what lies along one triangle is parted from what does not, and where two surfaces lie along each
// other, cut in any way, no more parts come of it than there are pairs of triangles above each other. Where there is no
// such side the cell is halved.
CellParts cut_cell(const TriangleTree& to, const FarthestCell& cell);

}  // namespace ryosen
