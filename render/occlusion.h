// What the surface drawn so far hides for certain, from the depths that it left.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <vector>

#include "render/gl/framebuffer.h"
#include "render/screen.h"

namespace ryosen {

// Keeps the farthest depth of small squares of pixels. Where something farther would be drawn, nothing would be seen of
// it.
class Occlusion {
 public:
  // Reads the depths of a rectangle; waits for what is being drawn.
  void read(const DrawTarget& drawn, const PixelRect& rect);

  // Whether what lies in the box, and is drawn inside `place`, cannot be seen in the rectangle that was read. Not asked
  // of what reaches in front of the near plane.
  bool hides(const DrawBox& box, const PixelRect& place, const glm::mat4& clip_from_buffer) const;

 private:
  static constexpr int square = 8;  // pixels

  PixelRect rect_;
  int columns_ = 0;
  std::vector<float> depths_;    // of pixels, rows top-down
  std::vector<float> farthest_;  // of squares
};

}  // namespace ryosen
