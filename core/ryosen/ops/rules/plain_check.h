// Fast path of the collapse and swap checks for ordinary edges between triangles.
//
// `unknown` means that the full check must run: a polygon, a ring anywhere, a copy of a point, a vertex with several
// fans or wires, a high valence. No allocation; one or two cache lines per neighbour.
#pragma once

#include "ryosen/mesh/mesh.h"

namespace ryosen {

enum class QuickAnswer { legal, refused, unknown };

// Whether an edge between two triangles may collapse if the apexes are the only common neighbours of its ends, from the
// total number of gaps and the valences of both ends. If both ends have no other neighbours, two equal triangles would
// remain.
constexpr bool is_ordinary_inner_edge(std::uint32_t gaps, std::uint32_t a_valence, std::uint32_t b_valence) {
  return gaps <= 1 && a_valence >= 3 && b_valence >= 3 && a_valence + b_valence > 6;
}

// Whether the live edge of h may collapse, from the one-rings of both ends, collected on the stack. O(valence).
QuickAnswer quick_collapse(const Mesh& mesh, Halfedge h);
// Whether it may be swapped, in either direction. O(valence of the vertex opposite h).
QuickAnswer quick_swap(const Mesh& mesh, Halfedge h);

}  // namespace ryosen
