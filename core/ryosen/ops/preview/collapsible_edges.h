// The legality of collapse for all edges of a mesh at once.
#pragma once

#include <cstdint>
#include <vector>

#include "ryosen/mesh/mesh.h"

namespace ryosen {

// One entry per edge slot: whether CollapseEdge{halfedge(e)} is legal; 0 for dead edges. Collects every one-ring once,
// so that an edge between triangles costs one intersection of two short lists: three to four times faster than edge by
// edge. Temporary memory: about 64 bytes per vertex. O(edges times valence).
std::vector<std::uint8_t> collapsible_edges(const Mesh& mesh);

}  // namespace ryosen
