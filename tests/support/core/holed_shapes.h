// Closed surfaces with handles, and of many parts, at places where they look like what they are.
#pragma once

#include <cstdint>

#include "ryosen/indexed/indexed.h"

namespace ryosen::test {

// Around the z axis: `around` quads one way and `across` the other, each cut in two. The tube is that thick.
IndexedMesh torus_at_places(std::uint32_t around, std::uint32_t across, double radius, double tube);
// A plate of unit cubes with so many square holes in a row, its squares cut in two: a sphere with as many handles.
IndexedMesh plate_with_holes(std::uint32_t holes);
// So many spheres of radius 1 in rows of ten, whose middles are so far from each other.
IndexedMesh rows_of_spheres(std::uint32_t count, double apart);
// So many spheres of different sizes at random in a box, some of which meet.
IndexedMesh scattered_spheres(std::uint32_t count, std::uint64_t seed);
// A torus without some of its triangles, at random.
IndexedMesh torn_torus(std::uint32_t missing, std::uint64_t seed);
// A flat square of triangles every second one of which is turned over.
IndexedMesh checkered_sheet(std::uint32_t side);

}  // namespace ryosen::test
