// Meshes on which costs explode where something is asked once for each neighbour, copy or overlap: each family by its
// number of faces, so that the growth of a cost can be seen at n, 2n and 4n.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "ryosen/indexed/indexed.h"

namespace ryosen::test {

struct UglyFamily {
  std::string_view id;
  std::string_view what;
  IndexedMesh (*make)(std::uint32_t n);
};

std::span<const UglyFamily> ugly_families();

// A ring of n triangles around one vertex.
IndexedMesh fan(std::uint32_t n);
// About n triangles between a ring of points and the two ends of its axis, closed.
IndexedMesh bipyramid(std::uint32_t n);
// n triangles on one edge, their third points on a circle around it.
IndexedMesh book(std::uint32_t n);
// n squares on one edge.
IndexedMesh book_of_squares(std::uint32_t n);
// n times the same triangle.
IndexedMesh equal_triangles(std::uint32_t n);
// About n unit cubes in a block, six quads each, on shared points: the inner quads lie back to back.
IndexedMesh voxel_block(std::uint32_t n);
// One polygon of n corners.
IndexedMesh large_face(std::uint32_t n);
// n triangles in all directions that share no point; a corner of each lies at the origin.
IndexedMesh apex_soup(std::uint32_t n);
// A strip of quads with n square holes in a row.
IndexedMesh comb_of_holes(std::uint32_t n);
// n long and very thin triangles around one corner, in a plane.
IndexedMesh sliver_fan(std::uint32_t n);
// n triangles on a line, each on three points in a row, so that neighbours disagree in direction.
IndexedMesh flat_chain(std::uint32_t n);
// About n triangles: those between an apex and a line of points, and flat ones on every second three of these.
IndexedMesh spokes_on_a_line(std::uint32_t n);
// n triangles that share no point, in pairs: a long side of one passes the origin, a side of the other lies along it
// and ends there.
IndexedMesh seams_at_a_point(std::uint32_t n);
// About n triangles of a regular grid.
IndexedMesh clean_grid(std::uint32_t n);

}  // namespace ryosen::test
