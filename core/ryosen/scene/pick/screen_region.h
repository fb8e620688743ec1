// A region of the picture: a polygon of pixels, as a box or a lasso draws it.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

namespace ryosen {

class ScreenRegion {
 public:
  // Inside is what an odd number of its sides surrounds. With fewer than three corners it holds nothing.
  explicit ScreenRegion(std::vector<glm::dvec2> corners);
  static ScreenRegion box(glm::dvec2 a, glm::dvec2 b);

  // O(corners) within its bounding box, else O(1).
  bool holds(glm::dvec2 pixel) const;

 private:
  std::vector<glm::dvec2> corners_;
  glm::dvec2 low_{0}, high_{0};
};

}  // namespace ryosen
