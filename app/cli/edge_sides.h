// The edges of a mesh as `why --all` goes through them.
#pragma once

#include <compare>
#include <string>
#include <vector>

#include "core/mesh/mesh.h"

namespace ryosen::cli {

// An edge between points a < b; where it is non-manifold or misoriented on points, one of its face sides.
struct EdgeSide {
  Vertex a, b;
  Face face;          // none where the edge is named by its points alone
  Halfedge halfedge;  // from a to b

  friend auto operator<=>(const EdgeSide&, const EdgeSide&) = default;
};

// By smaller point, larger point, face. O(edges log edges), and the stars of points with copies.
std::vector<EdgeSide> find_edge_sides(const Mesh& mesh);

// "3-7" or "3-7@f5"; the other way round when reversed.
std::string name_of(const EdgeSide& side, bool reversed = false);

}  // namespace ryosen::cli
