// Surfaces with holes.
#pragma once

#include <cstdint>
#include <functional>

#include "ryosen/indexed/from_indexed.h"

namespace ryosen::test {

// A wall of quads around the z axis, from a rim of radius 1 at z = 0 to one of another radius and height.
IndexedMesh tube(std::uint32_t corners, double radius, double height);
// The same, closed at z = 0 by one face.
IndexedMesh cup(std::uint32_t corners, double radius, double height);

// The lower part of a unit sphere of triangles, 2 n around; so many of n rows of latitude are missing at the top.
// `rise` moves the corners of the rim down by shares of a row, by their number.
IndexedMesh sphere_with_hole(
    std::uint32_t n, std::uint32_t missing_rows,
    const std::function<double(std::uint32_t)>& rise = [](std::uint32_t) { return 0.0; });

// Turned about the origin by angles that no coordinate survives.
IndexedMesh turned(IndexedMesh list);
// With places as a file of floats holds them.
IndexedMesh as_floats(IndexedMesh list);

// Spokes about one vertex, up and down seven times in a round.
IndexedMesh wavy_fan(std::uint32_t spokes);

}  // namespace ryosen::test
