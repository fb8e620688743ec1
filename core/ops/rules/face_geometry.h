// The shape of a face before and after an operator, for the geometric warnings.
#pragma once

#include <glm/vec3.hpp>
#include <utility>
#include <vector>

namespace ryosen {

class FaceGeometry {
 public:
  FaceGeometry() = default;
  explicit FaceGeometry(std::vector<glm::dvec3> corners) : corners_(std::move(corners)) {}
  void add(const glm::dvec3& corner) { corners_.push_back(corner); }
  std::size_t corners() const { return corners_.size(); }
  // All corners exactly on one line or at one place.
  bool is_degenerate() const;
  // Whether the normal of `after` makes 90 degrees or more with this one's. False where either has none.
  bool turns_against(const FaceGeometry& after) const;

 private:
  // Twice the area times the unit normal, by Newell's sum relative to the first corner.
  glm::dvec3 area_vector() const;

  std::vector<glm::dvec3> corners_;
};

// a + t (b - a), also where b - a is too large for a double.
glm::dvec3 point_between(const glm::dvec3& a, const glm::dvec3& b, double t);

// The parameter in [0, 1] of the point of the segment a-b that lies nearest to p; 1 where the segment has no length.
double closest_parameter(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& p);

}  // namespace ryosen
