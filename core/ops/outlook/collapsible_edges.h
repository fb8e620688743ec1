// Which edges of a mesh may collapse, for all of them at once.
#pragma once

#include <cstdint>
#include <vector>

#include "core/mesh/mesh.h"

namespace ryosen {

// One entry per slot of an edge: whether CollapseEdge{halfedge(e)} is legal; 0 for dead edges. Gathers the neighbours
// of every vertex once, so that an edge among triangles costs one comparison of two short lists: three to four times
// faster than asking edge by edge. Takes about 64 bytes per vertex meanwhile. O(edges times valence). For programs that
// use the library; this one asks about one edge at a time.
std::vector<std::uint8_t> collapsible_edges(const Mesh& mesh);

}  // namespace ryosen
