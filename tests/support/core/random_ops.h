// Random operators on any mesh, and random meshes with rings, bridges, wires, isolated vertices and several fans.
#pragma once

#include <cstdint>

#include "ryosen/ops/all.h"
#include "tests/support/core/random_meshes.h"

namespace ryosen::test {

// Elements that live, or none where there is none of the kind.
Vertex random_vertex(const Mesh& mesh, Dice& dice);
Halfedge random_halfedge(const Mesh& mesh, Dice& dice);
Face random_face(const Mesh& mesh, Dice& dice);

// The operator of this place in the list of operators, with arguments that live; they fit together more often than pure
// chance would have it. Without the elements that it needs: make_vertex.
AnyOp random_op(const Mesh& mesh, std::size_t place, Dice& dice);
// Any of them.
AnyOp random_op(const Mesh& mesh, Dice& dice);

// Applies it if it is legal; whether it was.
bool try_apply(Mesh& mesh, Journal* journal, const AnyOp& op);

// A small mesh made from random_mesh(), a manifold or nothing by holes, tunnels and random operators. Its points read
// back: no wire lies beside another edge, and the edges of its faces are joined as reading joins them.
Mesh random_complex(std::uint64_t seed);

}  // namespace ryosen::test
