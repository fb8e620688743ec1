// The resolve pass: downsamples a supersampled picture.
#pragma once

#include "render/gl/framebuffer.h"
#include "render/gl/program.h"
#include "ryosen/base/result.h"

namespace ryosen {

class ResolvePass {
 public:
  explicit ResolvePass(std::optional<Failure>& failure) : program_(failure, "resolve.vert", "resolve.frag") {}

  // Fills a rectangle of `target` from `rendered`, which is `factor` times as large in each dimension and holds it from
  // this lower left pixel on.
  void draw(const Framebuffer& rendered, int factor, const Framebuffer& target, const PixelRect& rect,
            glm::ivec2 lower_left = {0, 0}) const;

 private:
  Program program_;
  VertexArray no_attributes_{"resolve"};
};

}  // namespace ryosen
