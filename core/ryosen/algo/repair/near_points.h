// Points at one place, or close to each other, and the collapse of edges between them.
#pragma once

#include <span>
#include <vector>

#include "ryosen/base/progress.h"
#include "ryosen/mesh/edit.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// What is near.
struct Reach {
  double distance;
  std::span<const Vertex> used;  // elsewhere (AlgorithmInput): these stay in the file whatever becomes of them
  const std::vector<bool>* only = nullptr;  // by slot: no other point is near any; null: all may be
};

struct NearPoints {
  // By slot of a vertex the first point in file order that is no farther away from its point than the distance and is
  // itself a first one; the point itself where it is that, where its position is not finite, or where a wire ends at
  // it. Isolated points that are used elsewhere are no first ones. None for dead vertices.
  std::vector<Vertex> first;
  bool are_any = false;  // there is a point that is not the first one at its place
};
// O(vertices).
NearPoints find_near_points(const Mesh& mesh, const Reach& reach);

// Whether no copy of the point has an edge.
bool is_isolated_point(const Mesh& mesh, Vertex point);

// Whether an edge without a face ends at a copy of the point.
bool ends_a_wire(const Mesh& mesh, Vertex point);

// Collapses edges between points with the same first one where this is sound (collapses_soundly); the lower number
// stays. `near` are the points of the mesh as it is. Returns how many.
std::size_t collapse_near(Edit& edit, const NearPoints& near, Progress& progress);

}  // namespace ryosen
