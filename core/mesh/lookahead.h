// Fetches what operators on edges are going to touch, for batch work over edges in any order.
//
// A mesh of more than the processor's cache holds is slow in random order because each link followed waits for memory.
// Announcing edges some turns early lets those waits overlap:
//
//   Lookahead ahead(mesh, Lookahead::Around::ends);
//   for (std::size_t i = 0; i < edges.size(); ++i) {
//     if (i + Lookahead::distance < edges.size()) ahead.announce(edges[i + Lookahead::distance]);
//     ... check and apply an operator on edges[i] ...
//   }
//
// Changes no result; the mesh may be edited in between. Announced edges may be dead by the time of their turn.
// For programs that use the library; this one edits no edges in bulk.
#pragma once

#include <array>

#include "core/mesh/mesh.h"

namespace ryosen {

class Lookahead {
 public:
  // What the operator walks around: both ends of the edge (collapse) or the vertices opposite to it (swap).
  enum class Around { ends, apexes };
  static constexpr std::uint32_t distance = 8;

  Lookahead(const Mesh& mesh, Around around) : mesh_(mesh), around_(around) {}

  // Takes the edges announced before one step further and begins with this one. O(distance).
  void announce(Edge e);

 private:
  // Two walks around vertices, one each way. They go on until another edge takes their place.
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
