// The triangles of a mesh with corners numbered by point.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "ryosen/geometry/triangles_meet.h"
#include "ryosen/mesh/face_polygon.h"

namespace ryosen {

class NumberedSurface {
 public:
  // Of all faces with finite corners.
  explicit NumberedSurface(const Mesh& mesh);
  // Of these live faces, whatever the size of the mesh.
  NumberedSurface(const Mesh& mesh, std::span<const Face> faces);

  // Of these triangles between places, each a face of its own.
  NumberedSurface(std::vector<glm::dvec3> places, std::vector<std::array<std::uint32_t, 3>> corners);

  std::uint32_t slots() const { return static_cast<std::uint32_t>(corners_.size()); }
  Face face(std::uint32_t slot) const { return faces_[slot]; }
  // Copies of a point have the same number.
  NumberedTriangle triangle(std::uint32_t slot) const;
  // Whether the corners are collinear (exact).
  bool is_flat(std::uint32_t slot) const;
  // How many triangles have a corner at the point, by its number. O(triangles).
  std::vector<std::uint32_t> triangles_at_points() const;

  // A frame suited to floats: positions are translated by the origin, their median, then scaled to about one unit.
  const glm::dvec3& origin() const { return origin_; }
  double scale() const { return scale_; }
  // The cross product of two sides of a triangle in that frame, rounded: twice its area along its normal.
  glm::dvec3 scaled_normal(const NumberedTriangle& t) const;

 private:
  void add(const Mesh& mesh, Face f);
  void choose_frame();

  std::vector<std::array<std::uint32_t, 3>> corners_;  // numbers of points
  std::vector<Face> faces_;
  std::vector<std::uint8_t> sides_;
  std::vector<glm::dvec3> places_;  // by number
  glm::dvec3 origin_{0.0};
  double scale_ = 1.0;
  // Scratch of add.
  FacePolygon polygon_;
  std::vector<CornerTriangle> triangles_;
};

}  // namespace ryosen
