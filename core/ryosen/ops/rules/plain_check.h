// Fast path of the collapse and swap checks for ordinary edges between triangles.
//
// `unknown` means that the full check must run: a polygon, a ring anywhere, a copy of a point, a vertex with several
// fans or wires, a high valence. No allocation; one or two cache lines per neighbour.
#pragma once

#include <cstdint>
#include <cstring>

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

// Block size in which count_common() reads the second list.
inline constexpr std::uint32_t ring_block = 8;

// SIMD intersection count of two short lists of vertex numbers: the number of pairs of equal numbers among the first
// `a_count` of a and the first `b_count` of b. b must be padded to a whole block with numbers that are not in a.
inline std::uint32_t count_common(const std::uint32_t* a, std::uint32_t a_count, const std::uint32_t* b,
                                  std::uint32_t b_count) {
#if defined(__GNUC__)
  // Four numbers in one register; portable vector extension.
  using Four = std::uint32_t __attribute__((vector_size(16)));
  Four found{};
  for (std::uint32_t k = 0; k < b_count; k += ring_block) {
    Four low, high;
    std::memcpy(&low, b + k, sizeof low);
    std::memcpy(&high, b + k + 4, sizeof high);
    for (std::uint32_t i = 0; i < a_count; ++i) {
      const Four number{a[i], a[i], a[i], a[i]};
      found -= reinterpret_cast<Four>(low == number) + reinterpret_cast<Four>(high == number);
    }
  }
  return found[0] + found[1] + found[2] + found[3];
#else
  std::uint32_t found = 0;
  for (std::uint32_t i = 0; i < a_count; ++i)
    for (std::uint32_t k = 0; k < b_count; ++k) found += a[i] == b[k];
  return found;
#endif
}

}  // namespace ryosen
