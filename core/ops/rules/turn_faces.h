// A mesh with some of its faces turned over, connected anew.
#pragma once

#include <vector>

#include "core/ops/op.h"

namespace ryosen {

struct TurnedMesh {
  MeshColumns columns;
  OpEffect effect;
};

// The columns of the mesh in which every face f with turned[f] runs the other way round, its first corner and its rings
// kept. Points, faces and dead slots keep their numbers; an edge between a face that turns and one that does not comes
// apart, edges whose two faces agree now are closed, and new copies take numbers from vertex_slots() on. Wires stay
// between their vertices: all edges at a vertex change their order with its faces, or none. All attribute values stay
// with their corners, vertices and faces. O(n).
TurnedMesh turn_faces(const Mesh& mesh, const std::vector<bool>& turned);

}  // namespace ryosen
