// Small named meshes and how to write one down in a test.
#pragma once

#include <initializer_list>
#include <vector>

#include "ryosen/indexed/from_indexed.h"

namespace ryosen::test {

using Polygons = std::vector<std::vector<std::uint32_t>>;

// Points without a place of their own get distinct coordinates on a curve, so that nothing is degenerate by accident.
IndexedMesh indexed(const Polygons& faces, std::size_t points = 0);
Mesh make_mesh(const Polygons& faces, std::size_t points = 0);

// A random mesh by its seed (random_meshes.h), as these tests speak of meshes.
struct SeededMesh {
  Polygons faces;
  std::size_t points = 0;
};
SeededMesh seeded_mesh(std::uint64_t seed);

Polygons tetrahedron();
Polygons cube();
Polygons torus_grid(std::uint32_t rows, std::uint32_t columns);
Polygons two_quads();
// A vertex 0 in the middle of a ring of `spokes` triangles.
Polygons closed_fan(std::uint32_t spokes);
Polygons bow_tie();
Polygons fin();  // three triangles on the edge 0-1
Polygons moebius_strip();
Polygons two_tetrahedra_on_an_edge();

// The live faces as corner lists of vertices, in slot order.
Polygons polygons_of(const Mesh& mesh);

}  // namespace ryosen::test
