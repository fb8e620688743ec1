// Features are what remeshing keeps: edges that are only divided, and points that stay to the bit, but for seams that
// are weighed.
#pragma once

#include <cstdint>
#include <vector>

#include "ryosen/algo/seams/seam_mode.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen::remesh {

struct Features {
  // An edge is a seam where nothing but texture or normals makes it a feature. A vertex is one amid a seam, which two
  // of its edges are, or an end, where a seam ends or several meet.
  enum Kind : std::uint8_t { none, held, seam, seam_end };

  std::vector<std::uint8_t> edges;     // per edge slot, a kind
  std::vector<std::uint8_t> vertices;  // per vertex slot: of their ends, copies, and ends of wires
  bool weighs_seams = false;

  // Edges and points of seams may come and go along these where they are weighed.
  bool is_weighed(Edge e) const { return weighs_seams && edges[e.index] == seam; }
  bool is_weighed(Vertex v) const { return weighs_seams && vertices[v.index] == seam; }
};

// Boundaries, wires, non-manifold and misoriented edges, edges whose faces bend by at least the angle, edges where
// texture, material, group or another value of the faces changes, and those of faces with a corner that is not finite.
// Triangles. O(n).
Features find_features(const Mesh& mesh, double angle_rad, SeamMode seams = SeamMode::kept);

}  // namespace ryosen::remesh
