// The shape of a face before and after an operator, for the geometric warnings.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <utility>
#include <vector>

#include "ryosen/base/verdict.h"

namespace ryosen {

class FaceGeometry {
 public:
  FaceGeometry() = default;
  explicit FaceGeometry(std::vector<glm::dvec3> corners) : corners_(std::move(corners)) {}
  void add(const glm::dvec3& corner) { corners_.push_back(corner); }
  std::size_t corners() const { return corners_.size(); }
  // All corners exactly collinear or coincident.
  bool is_degenerate() const;
  // Whether the angle between the normals is 90 degrees or more. False if either has none.
  bool turns_against(const FaceGeometry& after) const;

 private:
  // Twice the vector area, by Newell's method relative to the first corner.
  glm::dvec3 area_vector() const;

  std::vector<glm::dvec3> corners_;
};

// What an operator would do to the shape of faces: those whose normal turns, and those that lose their area.
struct ShapeDoubts {
  std::vector<Element> turned, degenerate;

  // Looks at one face, which is called `what`.
  void compare(const FaceGeometry& before, const FaceGeometry& after, Element what);
  void add_to(std::vector<Reason>& reasons) const;
};

// The geometric warnings about parts that take the place of a face; none where it had no normal itself.
std::vector<Reason> warnings_of_parts(Face face, const FaceGeometry& before, std::span<const FaceGeometry> parts);

// a + t (b - a), even if b - a overflows.
glm::dvec3 point_between(const glm::dvec3& a, const glm::dvec3& b, double t);

// The parameter in [0, 1] of the point on the segment a-b nearest to p; 1 for a zero-length segment.
double closest_parameter(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& p);

}  // namespace ryosen
