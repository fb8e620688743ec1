// Solids on the points of a small grid, put together by merging points, with the faces in any order.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/indexed/indexed.h"
#include "tests/support/core/random_meshes.h"

namespace ryosen::test {

using GridPoint = std::array<int, 3>;

// Polygons on places of whole numbers. Equal places are one point.
class SolidBuilder {
 public:
  void add_face(const std::vector<GridPoint>& corners) { faces_.push_back(corners); }
  // Six squares, or twelve triangles.
  void add_cube(const GridPoint& lowest, bool triangles = false);
  // False: it has no volume, and nothing is added. Its faces look outwards.
  bool add_tetrahedron(std::array<GridPoint, 4> corners);
  // Turns the faces added since then.
  void turn(std::size_t from_face);
  void shuffle(Dice& dice);

  const std::vector<std::vector<GridPoint>>& faces() const { return faces_; }
  // Six times the volume of what was added.
  std::int64_t volume_six() const;
  IndexedMesh indexed() const;

 private:
  std::vector<std::vector<GridPoint>> faces_;
};

// Six times the signed volume of a tetrahedron.
std::int64_t volume_six(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d);

// Different cubes of a grid and tetrahedra on its points, which may overlap.
SolidBuilder random_union(std::uint64_t seed);
// Solids among sheets, fins, walls, doubled and turned faces; no face is without area.
SolidBuilder random_solids_and_sheets(std::uint64_t seed);
// Triangles on few points.
SolidBuilder random_triangles(std::uint64_t seed);

}  // namespace ryosen::test
