// What remeshing keeps: edges that are only divided, and points that stay to the bit.
#pragma once

#include <cstdint>
#include <vector>

#include "ryosen/mesh/mesh.h"

namespace ryosen::remesh {

struct Features {
  std::vector<std::uint8_t> edges;     // per edge slot
  std::vector<std::uint8_t> vertices;  // per vertex slot: their ends, copies, and ends of wires
};

// Boundaries, wires, non-manifold and misoriented edges, edges whose faces bend by at least the angle, edges where
// texture, material, group or another value of the faces changes, and those of faces with a corner that is not finite.
// Triangles. O(n).
Features find_features(const Mesh& mesh, double angle_rad);

}  // namespace ryosen::remesh
