// Pockets without room: two faces back to back, joined at all their sides.
#pragma once

#include <utility>
#include <vector>

#include "ryosen/mesh/mesh.h"

namespace ryosen {

// Each pair of faces of which all sides of one are paired with sides of the other that lie exactly on them. `across`
// has by halfedge slot the side paired with a side, or none (pair_faces.h). The lower face is first; ascending. O(n).
std::vector<std::pair<Face, Face>> find_pockets(const Mesh& mesh, const std::vector<Halfedge>& across);

// Pockets whose sides are joined in the mesh. O(n).
std::vector<std::pair<Face, Face>> pockets_of(const Mesh& mesh);

}  // namespace ryosen
