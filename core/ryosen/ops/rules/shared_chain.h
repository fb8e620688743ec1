// Chains of edges between the same two faces, through vertices with exactly two edges.
#pragma once

#include <span>
#include <vector>

#include "ryosen/mesh/mesh.h"

namespace ryosen {

// The chain from h on, h first.
std::vector<Halfedge> chain_from(const Mesh& mesh, Halfedge h);
// The whole chain that an edge lies in, in the direction of its twin; one that has no end begins with h.
std::vector<Halfedge> chain_through(const Mesh& mesh, Halfedge h);
// The vertices within a chain.
std::vector<Vertex> inner_vertices(const Mesh& mesh, std::span<const Halfedge> chain);

}  // namespace ryosen
