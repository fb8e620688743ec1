#include "render/pass/background.h"

#include "render/palette.h"

namespace ryosen {

void BackgroundPass::draw(const Frame& frame) const {
  const Palette& colours = palette(frame.settings.theme);
  use_for(frame, program_);
  program_.set("top_colour", glm::vec3(unit(colours.background_top)));
  program_.set("bottom_colour", glm::vec3(unit(colours.background_bottom)));
  program_.set("height_px", static_cast<float>(frame.size.height));
  set_drawing(Blend::none, GL_LEQUAL);
  glBindVertexArray(no_attributes_.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace ryosen
