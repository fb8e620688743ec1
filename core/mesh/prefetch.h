// Asks the processor to bring links near before they are read. Any handle may be named, one that is none too: the cache
// takes the address for a hint and nothing is read.
#pragma once

#include <cstdint>

#include "core/mesh/mesh.h"

namespace ryosen {

// Computed as a number, because a pointer must not leave its array.
template <class Cell>
void prefetch_cell(const Cell* column, std::uint32_t index) {
  __builtin_prefetch(
      reinterpret_cast<const void*>(reinterpret_cast<std::uintptr_t>(column) + std::uintptr_t{index} * sizeof(Cell)));
}

inline void prefetch(const Mesh& m, Halfedge h) { prefetch_cell(m.columns().halfedges.data(), h.index); }
inline void prefetch(const Mesh& m, Vertex v) { prefetch_cell(m.columns().vertex_halfedge.data(), v.index); }
inline void prefetch(const Mesh& m, Face f) { prefetch_cell(m.columns().face_halfedge.data(), f.index); }

}  // namespace ryosen
