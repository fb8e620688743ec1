// How long edges are to be: everywhere alike, or shorter where the surface bends.
#pragma once

#include <optional>
#include <vector>

#include "core/algo/remesh/triangle_shape.h"
#include "core/pick/triangle_tree.h"

namespace ryosen::remesh {

struct SizeOptions {
  double length = 1;  // where the surface is flat
  bool adaptive = false;
  double tolerance = 0;  // of adaptive ones: how far a triangle may leave the surface
};

// The surface as it was, to which new points are brought back, with the wanted length at each of its points.
class Target {
 public:
  // Of a mesh of triangles with coordinates of at most about 1; those with corners that are not finite are no surface. An
  // adaptive length is that of edges which leave a circle of the largest curvature by the
  // tolerance, but at least an eighth of `length` and at most all of it [Dunyach13]; O(n), and n log n for the tree.
  Target(const Mesh& mesh, const SizeOptions& options);

  struct Nearest {
    glm::dvec3 place;
    double length;
    std::uint32_t triangle;  // a number that is a good hint for places near this one
  };
  // The nearest place where the surface faces a direction: so what lies on one sheet does not come to another. Of a place
  // right over the hint, and near, that in the hint. None where there is no such place, and for a place that is not finite.
  std::optional<Nearest> nearest(const glm::dvec3& place, const glm::dvec3& direction,
                                 std::uint32_t hint = no_index) const;
  // A hint for the place of a vertex of the mesh; no_index where there is none.
  std::uint32_t hint_at(Vertex v) const { return hints_[v.index]; }
  double length_at(Vertex v) const { return lengths_.empty() ? options_.length : lengths_[v.index]; }
  double shortest_length() const { return is_adaptive() ? options_.length / 8 : options_.length; }
  bool is_adaptive() const { return !lengths_.empty(); }

 private:
  SizeOptions options_;
  TriangleTree tree_;
  std::vector<std::uint32_t> hints_;   // per vertex
  std::vector<double> lengths_;        // per vertex; empty where all are alike
  std::vector<double> point_lengths_;  // the same per point of the tree
};

// The largest absolute principal curvature at each vertex slot, by the cotangent Laplacian and the angle deficit over a
// third of the area around [Meyer03]; 0 at boundaries. Triangles.
std::vector<double> largest_curvatures(const Mesh& mesh);

}  // namespace ryosen::remesh
