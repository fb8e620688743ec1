// What all passes of one picture share.
#pragma once

#include <glm/mat4x4.hpp>

#include "core/view/size.h"
#include "render/palette.h"

namespace ryosen {

// Buffer space is the mesh moved to an origin and scaled evenly to about unit size, so that single precision serves.
// Sizes and rectangles are in rendered pixels, of which pixel_scale make one pixel of the picture.
struct Frame {
  glm::mat4 clip_from_buffer{1};
  glm::mat4 view_from_buffer{1};  // of the scale of the buffers: lengths stay
  glm::mat4 clip_from_view{1};
  bool ortho = false;
  float near_distance = 0;    // of the near plane
  float units_per_pixel = 0;  // at distance 1 from the eye; everywhere when ortho
  Size size;
  PixelRect rect;  // the part to draw; the scissor is set to it
  float pixel_scale = 1;
  Theme theme = Theme::dark;
};

}  // namespace ryosen
