// Flipping of faces with reconnection.
#pragma once

#include <vector>

#include "ryosen/ops/op.h"

namespace ryosen {

struct TurnedMesh {
  MeshColumns columns;
  OpEffect effect;
};

// The mesh with every face f with turned[f] reversed, keeping its first corner and rings. Points, faces and dead slots
// keep their numbers; edges between a flipped and an unflipped face are cut, edges whose two faces now agree are
// joined, and new copies are numbered from vertex_slots() on. Wires stay between their vertices; the cyclic order of
// all edges at a vertex is reversed with its faces. Attribute values stay with their corners, vertices and faces.
// `descent`: told where elements come from, as an edit tells it. O(n).
TurnedMesh turn_faces(const Mesh& mesh, const std::vector<bool>& turned, Descent* descent = nullptr);

}  // namespace ryosen
