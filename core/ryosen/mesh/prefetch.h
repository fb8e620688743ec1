// Prefetches the links of an element into the cache. Any handle is allowed, even none: the address is only a hint and
// is never dereferenced.
#pragma once

#include <cstdint>

#include "ryosen/mesh/mesh.h"

namespace ryosen {

// The line of the cache at an address. The empty statement keeps the call: g++ takes a function that does nothing else
// for one without any effect, and where it sees that from a caller in the same file, leaves out the calls.
inline void prefetch_line(const void* address) {
  __builtin_prefetch(address);
  asm volatile("");
}

// Integer arithmetic, because a pointer past the end of its array would be undefined behaviour.
template <class Cell>
void prefetch_cell(const Cell* column, std::uint32_t index) {
  prefetch_line(
      reinterpret_cast<const void*>(reinterpret_cast<std::uintptr_t>(column) + std::uintptr_t{index} * sizeof(Cell)));
}

inline void prefetch(const Mesh& m, Halfedge h) { prefetch_cell(m.columns().halfedges.data(), h.index); }
inline void prefetch(const Mesh& m, Vertex v) { prefetch_cell(m.columns().vertex_halfedge.data(), v.index); }
inline void prefetch(const Mesh& m, Face f) { prefetch_cell(m.columns().face_halfedge.data(), f.index); }

}  // namespace ryosen
