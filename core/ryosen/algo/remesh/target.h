// The surface as it was, to which new points are brought back, and how long edges are to be at each of its points:
// everywhere alike, or shorter where it bends.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "ryosen/algo/remesh/triangle_shape.h"
#include "ryosen/geometry/trees/triangle_tree.h"

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

class Target {
 public:
  // Of a mesh of triangles with coordinates of at most about 1; those with corners that are not finite are no surface.
  // Refers to the sizing. O(n log n).
  Target(const Mesh& mesh, const Sizing& sizing);

  struct Nearest {
    glm::dvec3 place;
    double length;
    std::uint32_t triangle;  // a number that is a good hint for places near this one
  };
  // The nearest place where the surface faces a direction: so what lies on one sheet does not come to another. Of a
  // place right over the hint or a triangle few steps from it, and near, that in this. None where there is no such
  // place, and for a place that is not finite.
  std::optional<Nearest> nearest(const glm::dvec3& place, const glm::dvec3& direction,
                                 std::uint32_t hint = no_index) const;
  // A face of the mesh, and the shares of its corners from its halfedge on.
  struct Share {
    Face face;
    std::array<double, 3> weights;
  };
  // Of the place of nearest(), or of the nearest one in a face that `may_be`.
  std::optional<Share> share(const glm::dvec3& place, const glm::dvec3& direction, std::uint32_t hint,
                             const std::function<bool(Face)>& may_be) const;
  // A hint for the place of a vertex of the mesh; no_index where there is none.
  std::uint32_t hint_at(Vertex v) const { return hints_[v.index]; }
  // Those with near numbers lie near each other.
  std::uint32_t triangles() const { return tree_.size(); }
  const Sizing& sizing() const { return sizing_; }

 private:
  void find_neighbours(const Mesh& mesh);
  bool comes_under(const glm::dvec3& place, std::uint32_t& triangle) const;

  const Sizing& sizing_;
  TriangleTree tree_;
  std::vector<std::array<std::uint32_t, 3>> beside_;  // per triangle those across its sides, from the first corner on
  std::vector<std::uint32_t> hints_;                  // per vertex
  std::vector<double> point_lengths_;                 // per point of the tree; empty where all are alike
};

}  // namespace ryosen::remesh
