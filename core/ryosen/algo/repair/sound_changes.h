// Collapses and deletions that leave no finding where there was none; and faces whose corners lie exactly on a line,
// now or with a corner elsewhere.
#pragma once

#include <optional>
#include <vector>

#include "ryosen/geometry/is_finite.h"
#include "ryosen/geometry/predicates.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/edit.h"

namespace ryosen {

// As the problem kind degenerate_area, with the corners where `place` says. Ends at the first corner beside the line.
template <class Place>
bool is_flat_at(const Mesh& mesh, Face f, Place place) {
  std::optional<glm::dvec3> a, b;
  for (Vertex v : vertices_around(mesh, f)) {
    const glm::dvec3 p = place(v);
    if (!is_finite(p)) return false;
    if (!a) a = p;
    if (!b && p != *a) b = p;
    if (b && !are_collinear(*a, *b, p)) return false;
  }
  return true;
}

inline bool is_flat(const Mesh& mesh, Face f) {
  return is_flat_at(mesh, f, [&](Vertex v) { return mesh.position(v); });
}

// Whether h may be collapsed onto its end, position included, without a new finding: the operator's verdict, no face
// becomes flat, and no pair of equal quads beside h becomes a hanging pair of triangles.
bool collapses_soundly(const Mesh& mesh, Halfedge h);

// Deletes faces, their edges that are left without a face, and vertices without an edge. A point that this makes
// non-manifold and an edge that it makes misoriented are taken apart (detach_points). Where two triangles would hang on
// each other (hanging_pair) without them, one of the faces at that edge stays, unless `may_leave_pairs`. Returns how
// many were deleted. Cost: O(k log k) for the k faces at the points of these faces.
std::size_t delete_soundly(Edit& edit, std::vector<Face> faces, bool may_leave_pairs = false);

}  // namespace ryosen
