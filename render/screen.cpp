#include "render/screen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

namespace ryosen {

PixelRect screen_bounds(std::span<const glm::vec3> points, const glm::mat4& clip_from_mesh, Size view, float reach) {
  if (points.empty()) return {};
  const float width = static_cast<float>(view.width), height = static_cast<float>(view.height);
  constexpr float infinity = std::numeric_limits<float>::infinity();
  float x0 = infinity, y0 = infinity, x1 = -infinity, y1 = -infinity;
  for (const glm::vec3& point : points) {
    const glm::vec4 clip = clip_from_mesh * glm::vec4(point, 1.0f);
    if (!(clip.w > 0 && clip.z >= -clip.w)) return PixelRect::all(view);
    const float x = (clip.x / clip.w + 1) * 0.5f * width;
    const float y = (1 - clip.y / clip.w) * 0.5f * height;
    x0 = std::min(x0, x);
    x1 = std::max(x1, x);
    y0 = std::min(y0, y);
    y1 = std::max(y1, y);
  }
  // One extra pixel covers rounding here and in the rasteriser.
  const float margin = reach + 1;
  const auto low = [](float value, int limit) {
    return static_cast<int>(std::clamp(std::floor(value), 0.0f, float(limit)));
  };
  const auto high = [](float value, int limit) {
    return static_cast<int>(std::clamp(std::ceil(value), 0.0f, float(limit)));
  };
  return {low(x0 - margin, view.width), low(y0 - margin, view.height), high(x1 + margin, view.width),
          high(y1 + margin, view.height)};
}

PixelRect screen_bounds(const DrawBox& box, const glm::mat4& clip_from_mesh, Size view, float reach) {
  if (box.empty()) return {};
  std::array<glm::vec3, 8> corners;
  for (std::size_t i = 0; i < 8; ++i) corners[i] = box.corner(i);
  return screen_bounds(corners, clip_from_mesh, view, reach);
}

}  // namespace ryosen
