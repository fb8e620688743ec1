// The parameters shared by all passes of one frame, how a pass begins, and colours as shaders take them.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "render/colour.h"
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

// Takes a program into use, and tells it what it reads of the frame and of the settings.
inline void use_for(const Frame& frame, const Program& program) {
  program.use();
  program.set("lower_left", glm::vec2(frame.lower_left));
  program.set("clip_from_buffer", frame.clip_from_buffer);
  program.set("view_from_buffer", frame.view_from_buffer);
  program.set("pixel_scale", frame.size_scale());
  program.set("units_per_pixel", frame.units_per_pixel);
  program.set("perspective", frame.ortho ? 0.0f : 1.0f);
  frame.settings.for_each([&](const char* name, int value) { program.set(name, value); });
}

// The ways in which what a pass draws, of premultiplied alpha, is laid over what is there.
enum class Blend { none, over, add };

// How a pass draws. Without a test of depths none are written.
inline void set_drawing(Blend blend, GLenum depth_test = GL_NONE, bool writes_depth = false) {
  const auto enable = [](GLenum what, bool is_on) { is_on ? glEnable(what) : glDisable(what); };
  enable(GL_BLEND, blend != Blend::none);
  if (blend != Blend::none) glBlendFunc(GL_ONE, blend == Blend::over ? GL_ONE_MINUS_SRC_ALPHA : GL_ONE);
  enable(GL_DEPTH_TEST, depth_test != GL_NONE);
  if (depth_test == GL_NONE) return;
  glDepthFunc(depth_test);
  glDepthMask(writes_depth ? GL_TRUE : GL_FALSE);
}

inline glm::vec4 unit(Rgba c) {
  return glm::vec4(static_cast<float>(c[0]), static_cast<float>(c[1]), static_cast<float>(c[2]),
                   static_cast<float>(c[3])) /
         255.0f;
}

// Linear light with gamma 2 (the shader converts back by a square root): close to the sRGB curve and cheap.
inline glm::vec4 linear(Rgba c) {
  const glm::vec4 v = unit(c);
  return {v.x * v.x, v.y * v.y, v.z * v.z, v.w};
}

}  // namespace ryosen
