// Fills what the surface left free with the theme's background.
#pragma once

#include "core/base/result.h"
#include "render/gl/program.h"
#include "render/pass/frame.h"

namespace ryosen {

class BackgroundPass {
 public:
  static Result<BackgroundPass> make();

  // Draws only where the depth buffer still holds the far plane.
  void draw(const Frame& frame) const;

 private:
  explicit BackgroundPass(Program program) : program_(std::move(program)), no_attributes_("background") {}

  Program program_;
  VertexArray no_attributes_;
};

}  // namespace ryosen
