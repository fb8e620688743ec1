// A mesh with some of its faces turned over, connected anew.
#pragma once

#include <vector>

#include "core/mesh/mesh.h"

namespace ryosen {

// The columns of the mesh in which every face f with turned[f] runs the other way round, its first corner kept. Points,
// faces and dead slots keep their numbers; copies are made anew and take numbers from vertex_slots() on. All attribute
// values stay with their corners, vertices and faces. O(n).
MeshColumns turn_faces(const Mesh& mesh, const std::vector<bool>& turned);

}  // namespace ryosen
