#include "render/pass/resolve.h"

#include "render/pass/frame.h"

namespace ryosen {

void ResolvePass::draw(const Framebuffer& rendered, int factor, const Framebuffer& target, const PixelRect& rect,
                       glm::ivec2 lower_left) const {
  target.bind(rect);
  program_.use();
  program_.set("rendered", 0);
  program_.set("factor", factor);
  program_.set("lower_left", lower_left);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, rendered.texture());
  set_drawing(Blend::none);
  glBindVertexArray(no_attributes_.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace ryosen
