// What a mesh must be for a subdivision by index arithmetic, and what is sharp on it.
#pragma once

#include <optional>

#include "ryosen/algo/subdivide/creases.h"
#include "ryosen/algo/subdivide/subdivide.h"
#include "ryosen/mesh/descent.h"

namespace ryosen::subdivide {

// A mesh whose edges are all alive, without rings, bridges and, where asked for, without polygons.
struct Prepared {
  std::optional<Mesh> changed;  // none where the mesh is so already
  Creases creases;
  // Polygons, or faces with rings, that were cut into triangles; and, for triangles, one of two with two common edges.
  std::size_t cut_faces = 0;
  std::size_t seams = 0;      // edges that are creases because the texture is torn there
  std::optional<Text> fault;  // a face that cannot be cut; then nothing else holds
};

// `descent`: null, or told where the elements come from.
Prepared prepare(const Mesh& mesh, const Options& options, Descent* descent);

// Before an edge is cut in two: a non-manifold edge gets an edge of its own for each of its faces, as reading the
// points of the result will give; sheets that were joined there are joined no more. None where there is no such edge.
// `descent` as for prepare().
std::optional<Mesh> with_open_sheets(const Mesh& mesh, Creases& creases, Descent* descent);
// Where edges are not cut: makes the joined sheets of a non-manifold edge creases.
void mark_shut_sheets(const Mesh& mesh, Creases& creases);

}  // namespace ryosen::subdivide
