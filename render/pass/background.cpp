#include "render/pass/background.h"

#include "render/palette.h"
#include "render/pass/linear.h"

namespace ryosen {

Result<BackgroundPass> BackgroundPass::make() {
  Result<Program> program = Program::make("background.vert", "background.frag");
  if (!program) return program.failure();
  return BackgroundPass(std::move(*program));
}

void BackgroundPass::draw(const Frame& frame) const {
  const Palette& colours = palette(frame.settings.theme);
  program_.use();
  pass_settings(program_, frame);
  program_.set("top_colour", glm::vec3(unit(colours.background_top)));
  program_.set("bottom_colour", glm::vec3(unit(colours.background_bottom)));
  program_.set("height_px", static_cast<float>(frame.size.height));
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glDepthMask(GL_FALSE);
  glBindVertexArray(no_attributes_.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace ryosen
