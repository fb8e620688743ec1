// Faces whose corners lie exactly on a line, now or with a corner elsewhere, and collapses that make none.
#pragma once

#include <optional>

#include "ryosen/geometry/is_finite.h"
#include "ryosen/geometry/predicates.h"
#include "ryosen/mesh/circulate.h"

namespace ryosen {

// As the problem kind degenerate_area, with the corners where `place` says. Ends at the first corner beside the line.
template <class Place>
bool is_flat_at(const Mesh& mesh, Face f, Place place) {
  std::optional<glm::dvec3> a, b;
  bool is_flat = true;
  for (Vertex v : vertices_around(mesh, f)) {
    const glm::dvec3 p = place(v);
    if (!is_finite(p)) return false;
    if (!a) a = p;
    if (!b && p != *a) b = p;
    if (b && is_flat) is_flat = are_collinear(*a, *b, p);
    if (!is_flat) break;
  }
  return is_flat;
}

inline bool is_flat(const Mesh& mesh, Face f) {
  return is_flat_at(mesh, f, [&](Vertex v) { return mesh.position(v); });
}

// Whether h may be collapsed onto its end, position included, without a new finding: the operator's verdict, no face
// becomes flat, and no pair of equal quads beside h becomes a hanging pair of triangles.
bool collapses_soundly(const Mesh& mesh, Halfedge h);

}  // namespace ryosen
