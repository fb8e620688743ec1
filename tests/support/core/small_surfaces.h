// All small surfaces: closed triangulated ones, what dissolving edges makes of them, and their parts.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/support/core/oracle/polygons.h"

namespace ryosen::test {

struct Surface {
  int vertices = 0;
  std::vector<oracle::Corners> triangles;  // neighbours agree in direction where that is possible
  bool orientable = true;
};

// The closed connected surfaces of exactly n vertices up to isomorphism, every edge with two triangles and every vertex
// with one cycle of them. Lexicographic search: the triangles around a vertex of the largest degree are given, then
// again and again the first open edge gets its second triangle. n = 8 takes about a second.
std::vector<Surface> closed_surfaces(int n);

// Every polygon mesh that dissolving a set of edges makes of a surface: each face still has every corner once.
using VisitFaces = std::function<void(const std::vector<oracle::Corners>&)>;
void for_each_dissolution(const Surface& surface, const VisitFaces& visit);

// Every set of faces, not empty, that hang together through common edges, or through common vertices; all faces
// included.
enum class Through { edges, vertices };
void for_each_connected_part(const std::vector<oracle::Corners>& faces, Through through, const VisitFaces& visit);

// Equal for two meshes exactly when one becomes the other by renumbering, and turning over all faces together. The
// faces must hang together through edges, each with at most one face in either direction.
std::string code_of(const std::vector<oracle::Corners>& faces);

}  // namespace ryosen::test
