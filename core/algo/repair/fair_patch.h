// Makes a patch of triangles as fine and as smooth as the surface around it.
#pragma once

#include <vector>

#include "core/base/progress.h"
#include "core/mesh/edit.h"

namespace ryosen {

struct Patch {
  std::vector<Face> faces;       // triangles, without rings
  std::vector<Vertex> boundary;  // its vertices that were there before, in any order
  std::vector<Vertex> inner;     // its own
};

// Divides triangles whose middle is far from their corners, measured by the length of the edges there, and swaps edges
// towards a Delaunay triangulation, by turns [Liepa03]. Edges of the boundary stay. New faces and vertices are added to
// the patch. Stops at a hundred thousand of them.
void refine(Edit& edit, Patch& patch, Progress& progress);

// Moves the inner vertices to where the patch bends least, as a thin plate that leaves the surface in its direction: the
// sum over its vertices, border included, of area times squared mean curvature normal, by cotangent weights [Botsch04].
// By conjugate gradients, at most a thousand steps, with the weights renewed a few times.
void fair(Edit& edit, const Patch& patch, Progress& progress);

}  // namespace ryosen
