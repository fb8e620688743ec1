#include "ryosen/scene/pick/screen_region.h"

#include <algorithm>
#include <glm/common.hpp>

namespace ryosen {

ScreenRegion::ScreenRegion(std::vector<glm::dvec2> corners) : corners_(std::move(corners)) {
  if (corners_.empty()) return;
  low_ = high_ = corners_[0];
  for (const glm::dvec2& corner : corners_) {
    low_ = glm::min(low_, corner);
    high_ = glm::max(high_, corner);
  }
}

ScreenRegion ScreenRegion::box(glm::dvec2 a, glm::dvec2 b) {
  return ScreenRegion({{a.x, a.y}, {b.x, a.y}, {b.x, b.y}, {a.x, b.y}});
}

bool ScreenRegion::holds(glm::dvec2 pixel) const {
  if (pixel.x < low_.x || pixel.y < low_.y || pixel.x > high_.x || pixel.y > high_.y) return false;
  bool is_inside = false;
  for (std::size_t i = 0, j = corners_.size() - 1; i < corners_.size(); j = i++) {
    const glm::dvec2 &a = corners_[i], &b = corners_[j];
    if ((a.y > pixel.y) == (b.y > pixel.y)) continue;
    if (pixel.x < a.x + (pixel.y - a.y) / (b.y - a.y) * (b.x - a.x)) is_inside = !is_inside;
  }
  return is_inside;
}

}  // namespace ryosen
