// Solids on the points of a small grid, put together by merging points, with the faces in any order.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ryosen/indexed/indexed.h"
#include "tests/support/core/random_meshes.h"

namespace ryosen::test {

using LatticePoint = std::array<int, 3>;
using LatticeVector = std::array<std::int64_t, 3>;

inline LatticeVector difference(const LatticePoint& a, const LatticePoint& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline LatticeVector cross(const LatticeVector& u, const LatticeVector& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}
inline std::int64_t dot(const LatticeVector& u, const LatticeVector& v) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

// Polygons on places of whole numbers. Equal places are one point.
class SolidBuilder {
 public:
  void add_face(const std::vector<LatticePoint>& corners) { faces_.push_back(corners); }
  // Six squares, or twelve triangles.
  void add_cube(const LatticePoint& lowest, bool triangles = false);
  // False: it has no volume, and nothing is added. Its faces look outwards.
  bool add_tetrahedron(std::array<LatticePoint, 4> corners);
  // Turns the faces added since then.
  void turn(std::size_t from_face);
  void shuffle(Dice& dice);

  const std::vector<std::vector<LatticePoint>>& faces() const { return faces_; }
  // Six times the volume of what was added.
  std::int64_t volume_six() const;
  IndexedMesh indexed() const;
  // With points of its own for each face.
  IndexedMesh loose() const;

 private:
  std::vector<std::vector<LatticePoint>> faces_;
};

// Six times the signed volume of a tetrahedron.
std::int64_t volume_six(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c, const LatticePoint& d);

// Different cubes of a grid and tetrahedra on its points, which may overlap.
SolidBuilder random_union(std::uint64_t seed);
// Solids among sheets, fins, walls, doubled and turned faces; no face is without area.
SolidBuilder random_solids_and_sheets(std::uint64_t seed);
// Triangles on few points.
SolidBuilder random_triangles(std::uint64_t seed);

}  // namespace ryosen::test
