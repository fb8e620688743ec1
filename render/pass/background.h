// The background pass: fills the pixels not covered by the surface.
#pragma once

#include "render/gl/program.h"
#include "render/pass/frame.h"
#include "ryosen/base/result.h"

namespace ryosen {

class BackgroundPass {
 public:
  static Result<BackgroundPass> make();

  // Draws only where the depth buffer is at the far plane.
  void draw(const Frame& frame) const;

 private:
  explicit BackgroundPass(Program program) : program_(std::move(program)), no_attributes_("background") {}

  Program program_;
  VertexArray no_attributes_;
};

}  // namespace ryosen
