// Prefetches the links of an element into the cache. Any handle is allowed, even none: the address is only a hint and
// is never dereferenced.
#pragma once

#include <array>
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

// Software prefetch of what edge operators will touch, for batch work over edges in random order.
//
// On a mesh larger than the cache, random order is slow because every dependent link load is a cache miss. Announcing
// edges a few iterations ahead overlaps those misses:
//
//   Lookahead ahead(mesh, Lookahead::Around::ends);
//   for (std::size_t i = 0; i < edges.size(); ++i) {
//     if (i + Lookahead::distance < edges.size()) ahead.announce(edges[i + Lookahead::distance]);
//     ... check and apply an operator on edges[i] ...
//   }
//
// Only a hint: results do not change, the mesh may be edited in between, and announced edges may die before their turn.
class Lookahead {
 public:
  // Whose one-rings the operator visits: both ends of the edge (collapse) or the opposite vertices (swap).
  enum class Around { ends, apexes };
  static constexpr std::uint32_t distance = 8;

  Lookahead(const Mesh& mesh, Around around) : mesh_(mesh), around_(around) {}

  // Advances the prefetch of the edges announced before by one step and starts that of this one. O(distance).
  void announce(Edge e);

 private:
  // Two walks around vertices, one in each direction. They continue until another edge takes the slot.
  struct Walks {
    Halfedge counter_clockwise, clockwise;
    bool begins = false;
  };
  void begin(Walks& walks) const;
  void step(Walks& walks) const;

  const Mesh& mesh_;
  Around around_;
  std::array<Walks, distance> announced_;
  std::uint32_t next_place_ = 0;
};

}  // namespace ryosen
