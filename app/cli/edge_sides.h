// Enumeration of the edges of a mesh for `why --all`.
#pragma once

#include <compare>
#include <string>
#include <vector>

#include "ryosen/mesh/mesh.h"

namespace ryosen::cli {

// An edge between points a < b; if it is non-manifold or misoriented on points, one of its face sides.
struct EdgeSide {
  Vertex a, b;
  Face face;          // none if the points suffice to name the edge
  Halfedge halfedge;  // from a to b

  friend auto operator<=>(const EdgeSide&, const EdgeSide&) = default;
};

// Sorted by smaller point, larger point, face. O(edges log edges), plus the one-rings of points with copies.
std::vector<EdgeSide> find_edge_sides(const Mesh& mesh);

// "3-7" or "3-7@f5"; reversed: points swapped.
std::string name_of(const EdgeSide& side, bool reversed = false);

}  // namespace ryosen::cli
