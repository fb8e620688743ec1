#include "render/pass/resolve.h"

namespace ryosen {

Result<ResolvePass> ResolvePass::make() {
  Result<Program> program = Program::make("resolve.vert", "resolve.frag");
  if (!program) return program.failure();
  return ResolvePass(std::move(*program));
}

void ResolvePass::draw(const Framebuffer& rendered, int factor, const Framebuffer& target, const PixelRect& rect,
                       glm::ivec2 lower_left) const {
  target.bind(rect);
  program_.use();
  program_.set("rendered", 0);
  program_.set("factor", factor);
  program_.set("lower_left", lower_left);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, rendered.texture());
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glDisable(GL_DEPTH_TEST);
  glBindVertexArray(no_attributes_.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace ryosen
