// What all passes of one picture share.
#pragma once

#include <glm/mat4x4.hpp>

#include "render/palette.h"
#include "render/size.h"

namespace ryosen {

// Matrices take positions relative to the origin of the buffers. Sizes and rectangles are in rendered pixels, of which
// pixel_scale make one pixel of the picture.
struct Frame {
  glm::mat4 clip_from_mesh{1};
  glm::mat4 view_from_mesh{1};
  bool ortho = false;
  float units_per_pixel = 0;  // at distance 1 from the eye; everywhere when ortho
  Size size;
  PixelRect rect;  // the part to draw; the scissor is set to it
  float pixel_scale = 1;
  Theme theme = Theme::dark;
};

}  // namespace ryosen
