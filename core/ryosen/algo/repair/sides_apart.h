// Sides of faces between two places, and those that lie on each other without being joined.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "ryosen/base/interruption.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// Calls visit(side) with each halfedge that has a face. May be interrupted (base/interruption.h).
template <class Visit>
void for_each_side(const Mesh& mesh, Visit visit) {
  for (const Halfedge h : live_halfedges(mesh)) {
    stop_if_interrupted(h.index);
    if (!mesh.is_outside(h)) visit(h);
  }
}

// A side of a face, ordered by its ends: points or places, of which each has one vertex that stands for it.
struct SideBetween {
  SideBetween(Vertex from, Vertex to, Halfedge side)
      : low(std::min(from, to)), high(std::max(from, to)), halfedge(side), is_forward(from < to) {}

  Vertex low, high;
  Halfedge halfedge;
  bool is_forward;  // from low to high

  friend auto operator<=>(const SideBetween&, const SideBetween&) = default;
};

// Calls visit(sides) with all sides between the same two ends; they are sorted.
template <class Visit>
void for_each_edge(std::span<const SideBetween> sorted, Visit visit) {
  for (std::size_t first = 0, last = 0; first < sorted.size(); first = last) {
    while (last < sorted.size() && sorted[last].low == sorted[first].low && sorted[last].high == sorted[first].high)
      ++last;
    visit(sorted.subspan(first, last - first));
  }
}

// Halfedges with a face and none beyond, between the same two places; first < second.
struct SidePair {
  Halfedge first, second;
  bool runs_alike;  // both run in the same direction
};

// The pairs that are the only sides of faces between two places, in the order of the places. `place` has by vertex slot
// the point that stands for its place. Only pairs that are not between the same two points already.
// O(n log n).
std::vector<SidePair> sides_at_one_place(const Mesh& mesh, const std::vector<Vertex>& place);

// Halfedges with a face and none beyond that are the only sides of faces between two places, both finite; ascending.
// O(n log n).
std::vector<Halfedge> lone_sides(const Mesh& mesh, const std::vector<Vertex>& place);

// The faces to turn, as few as possible, so that as many pairs as can run in opposite directions while neighbours stay
// turned alike; empty where none is to be turned. O(n log n).
std::vector<bool> turns_of(const Mesh& mesh, const std::vector<SidePair>& pairs);

}  // namespace ryosen
