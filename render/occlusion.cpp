#include "render/occlusion.h"

#include <algorithm>
#include <glm/vec4.hpp>

namespace ryosen {

void Occlusion::read(const DrawTarget& drawn, const PixelRect& rect) {
  rect_ = rect;
  columns_ = (rect.width() + square - 1) / square;
  const int rows = (rect.height() + square - 1) / square;
  depths_.resize(static_cast<std::size_t>(rect.width()) * static_cast<std::size_t>(rect.height()));
  drawn.read_depth(rect, depths_.data());
  farthest_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows), 0);
  const float* depth = depths_.data();
  for (int y = 0; y < rect.height(); ++y) {
    float* const of_row = farthest_.data() + std::ptrdiff_t{y / square} * columns_;
    for (int x = 0; x < rect.width(); ++x) of_row[x / square] = std::max(of_row[x / square], *depth++);
  }
}

bool Occlusion::hides(const DrawBox& box, const PixelRect& place, const glm::mat4& clip_from_buffer) const {
  float nearest = 1, farthest = 0;
  for (unsigned i = 0; i < 8; ++i) {
    const glm::vec4 corner((i & 1) ? box.max.x : box.min.x, (i & 2) ? box.max.y : box.min.y,
                           (i & 4) ? box.max.z : box.min.z, 1.0f);
    const glm::vec4 clip = clip_from_buffer * corner;
    if (!(clip.w > 0 && clip.z >= -clip.w)) return false;
    const float depth = 0.5f * clip.z / clip.w + 0.5f;
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  // The depth of a pixel at the rim of a steep triangle may lie beyond that of its corners.
  constexpr float rounding = 1e-5f;
  const float certain = nearest - (farthest - nearest) - rounding;
  const PixelRect inside = intersection(place, rect_);
  if (inside.empty()) return true;
  for (int y = (inside.y0 - rect_.y0) / square; y <= (inside.y1 - 1 - rect_.y0) / square; ++y)
    for (int x = (inside.x0 - rect_.x0) / square; x <= (inside.x1 - 1 - rect_.x0) / square; ++x)
      if (farthest_[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x)] >=
          certain)
        return false;
  return true;
}

}  // namespace ryosen
