// Quick certainty for the ordinary edge: a collapse or swap among triangles that is legal or refused beyond doubt.
//
// Unknown means that the full judgement has to be asked: a polygon, a ring anywhere, a copy of a point, a vertex of
// several fans or wires, a high valence. Both are const walks without memory of their own, one or two cache lines per
// neighbour.
#pragma once

#include "core/mesh/mesh.h"

namespace ryosen {

enum class QuickAnswer { legal, refused, unknown };

// Whether an edge between two triangles may collapse if its ends have no neighbours in common but the apexes, from the
// gaps around both ends and their valences. Two ends without other neighbours would leave two equal triangles.
constexpr bool is_ordinary_inner_edge(std::uint32_t gaps, std::uint32_t a_valence, std::uint32_t b_valence) {
  return gaps <= 1 && a_valence >= 3 && b_valence >= 3 && a_valence + b_valence > 6;
}

// Whether the live edge of h may collapse, from the rings of both ends, gathered on the stack. O(valence).
QuickAnswer quick_collapse(const Mesh& mesh, Halfedge h);
// Whether it may be swapped, in either direction. O(valence of the vertex opposite to h).
QuickAnswer quick_swap(const Mesh& mesh, Halfedge h);

}  // namespace ryosen
