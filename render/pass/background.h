// The background pass: fills the pixels not covered by the surface.
#pragma once

#include "render/gl/program.h"
#include "render/pass/frame.h"
#include "ryosen/base/result.h"

namespace ryosen {

class BackgroundPass {
 public:
  explicit BackgroundPass(std::optional<Failure>& failure) : program_(failure, "background.vert", "background.frag") {}

  // Draws only where the depth buffer is at the far plane.
  void draw(const Frame& frame) const;

 private:
  Program program_;
  VertexArray no_attributes_{"background"};
};

}  // namespace ryosen
