// Pairing of the faces at edges on points, so that solids that share edges or faces stay whole.
//
//      |   |             two solids on one wall: its edge has four faces, of which each wall is paired
//    --+===+--           with the side of its own solid
//      |   |
#pragma once

#include <vector>

#include "ryosen/mesh/mesh.h"

namespace ryosen {

struct FacePairing {
  std::vector<Halfedge> across;     // by halfedge slot: the side of the face paired with this side, or none
  std::vector<std::uint32_t> part;  // by face slot: the lowest face of those connected through pairs
  std::vector<bool> is_closed;      // by face slot: no side of its part is without a pair
  std::vector<bool> is_free;        // by face slot: its patch was set free
  std::size_t open_sides = 0;       // without a pair, but for those of edges of two faces in one direction
  bool has_nonmanifold_edges = false;
};

// Two opposite faces of an edge, and no third, are paired; faces connected so are a patch. While an edge of three or
// more faces has more of one direction, the patch of these that has a boundary edge, else the smallest, else the one of
// the lowest face, is set free: its sides at such edges have no pair. The others at such an edge are paired by their
// angles, exactly. Two faces in one direction have no pair. O(n log n).
FacePairing pair_faces(const Mesh& mesh);

// The same for points at one place: the sides that have a face beyond are paired with that, and the others between two
// places by the rule; pairs are exchanged where two vertices would have two edges (fan_groups.h). `place` has by vertex
// slot the one that stands for its place.
FacePairing pair_at_places(const Mesh& mesh, const std::vector<Vertex>& place);

// Whether in a mesh with the same faces more sides are open, or a face of a closed part is in an open one. Only meshes
// with non-manifold edges can be torn.
bool is_torn(const Mesh& before, const Mesh& after);

}  // namespace ryosen
