// How long edges are to be: everywhere alike, or shorter where the surface bends.
#pragma once

#include <vector>

#include "ryosen/algo/remesh/triangle_shape.h"

namespace ryosen::remesh {

struct SizeOptions {
  double length = 1;  // where the surface is flat
  bool adaptive = false;
  double tolerance = 0;  // of adaptive ones: how far a triangle may leave the surface
};

// The wanted length at each vertex of a mesh of triangles.
class Sizing {
 public:
  // An adaptive length is that of edges which leave a circle of the largest curvature by the tolerance, but at least an
  // eighth of `length` and at most all of it [Dunyach13]. O(n).
  Sizing(const Mesh& mesh, const SizeOptions& options);

  double length_at(Vertex v) const { return lengths_.empty() ? options_.length : lengths_[v.index]; }
  double longest() const { return options_.length; }
  double shortest() const { return is_adaptive() ? options_.length / 8 : options_.length; }
  bool is_adaptive() const { return !lengths_.empty(); }

 private:
  SizeOptions options_;
  std::vector<double> lengths_;  // per vertex; empty where all are alike
};

// The largest absolute principal curvature at each vertex slot, by the cotangent Laplacian and the angle deficit over a
// third of the area around [Meyer03]; 0 at boundaries. Triangles.
std::vector<double> largest_curvatures(const Mesh& mesh);

}  // namespace ryosen::remesh
