// The parameters shared by all passes of one frame.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "render/gl/program.h"
#include "ryosen/scene/view/size.h"
#include "ryosen/scene/view/view_settings.h"

namespace ryosen {

// Buffer space is mesh space translated to an origin and scaled uniformly to about unit size, so that single precision
// suffices. Sizes and rectangles are in rendered pixels; a picture pixel is pixel_scale of them wide. Lines, points and
// patterns are sized in pixels of a display at scale 1.
struct Frame {
  glm::mat4 clip_from_buffer{1};
  glm::mat4 view_from_buffer{1};  // a rigid transform: keeps the scale of the buffers
  glm::mat4 clip_from_view{1};
  bool ortho = false;
  float near_distance = 0;    // distance of the near plane
  float units_per_pixel = 0;  // at distance 1 from the eye; everywhere when ortho
  Size size;
  PixelRect rect;            // the part to draw; also the scissor
  glm::ivec2 lower_left{0};  // of what is drawn into, in the picture
  float pixel_scale = 1;
  float display_scale = 1;
  std::uint32_t thinning = 1;  // every so many-th triangle of the surface is drawn
  bool is_cut = false;
  glm::vec4 clip_plane{0, 0, 0, 1};  // in buffer space: what is kept is on it or where (x, y, z, 1) times it is above 0
  ViewSettings settings;

  // Rendered pixels per pixel of a display at scale 1.
  float size_scale() const { return pixel_scale * display_scale; }
};

// Tells a shader, which is in use, the settings that it reads, and where it draws.
inline void pass_settings(const Program& program, const Frame& frame) {
  program.set("lower_left", glm::vec2(frame.lower_left));
  frame.settings.for_each([&](const char* name, int value) { program.set(name, value); });
}

}  // namespace ryosen
