// Vertices of so many edges that not all of them can be looked at whenever something changes at one.
#pragma once

#include "core/mesh/mesh.h"

namespace ryosen {

// Of a vertex with edges. Cost: at most 64 steps.
inline bool is_hub(const Mesh& mesh, Vertex v) {
  constexpr int most = 64;
  int count = 0;
  for (Halfedge h = mesh.halfedge(v); ++count <= most;) {
    h = mesh.counter_clockwise(h);
    if (h == mesh.halfedge(v)) return false;
  }
  return true;
}

}  // namespace ryosen
