// Refinement and fairing of a patch of triangles to match the surrounding surface.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/mesh/edit.h"

namespace ryosen {

struct Patch {
  std::vector<Face> faces;       // triangles, without rings
  std::vector<Vertex> boundary;  // vertices of the hole boundary, in any order
  std::vector<Vertex> inner;     // vertices added inside
};

// Alternately splits triangles whose centroid is far from their corners relative to the edge lengths there, and swaps
// edges towards a Delaunay triangulation [Liepa03]. Boundary edges stay. New faces and vertices are added to the patch,
// at most 100000.
void refine(Edit& edit, Patch& patch, Progress& progress);

// Moves the inner vertices to minimise the thin-plate energy, with tangent continuity at the boundary: the sum over the
// vertices, boundary included, of area times squared mean curvature normal, with cotangent weights [Botsch04].
// Conjugate gradients, at most 1000 steps; the weights are recomputed a few times.
void fair(Edit& edit, const Patch& patch, Progress& progress);

}  // namespace ryosen
