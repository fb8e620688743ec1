// Vertices of so many edges that not all of them can be looked at whenever something changes at one.
#pragma once

#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

inline constexpr int most_looked_at = 64;

// Counts on by the edges of a vertex, or by one if it has none, and tells whether there are many.
inline bool are_many_with(const Mesh& mesh, Vertex v, int& count) {
  if (mesh.is_isolated(v)) return ++count > most_looked_at;
  for (Halfedge h = mesh.halfedge(v); ++count <= most_looked_at;) {
    h = mesh.counter_clockwise(h);
    if (h == mesh.halfedge(v)) return false;
  }
  return true;
}

// Cost: at most 64 steps.
inline bool is_hub(const Mesh& mesh, Vertex v) {
  int count = 0;
  return are_many_with(mesh, v, count);
}

// Of a point, by all its copies together. Cost: at most 64 steps.
inline bool is_hub_point(const Mesh& mesh, Vertex v) {
  int count = 0;
  return any_of_copies(mesh, v, [&](Vertex copy) { return are_many_with(mesh, copy, count); });
}

}  // namespace ryosen
