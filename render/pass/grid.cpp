#include "render/pass/grid.h"

#include <algorithm>
#include <cmath>

#include "render/palette.h"
#include "ryosen/scene/view/round_step.h"

namespace ryosen {

Ground ground_below(const DrawBox& given, const BufferSpace& space) {
  constexpr double reaches = 1.6, below = 0.002;
  constexpr DrawBox around_origin{glm::vec3(-0.5f), glm::vec3(0.5f)};
  const DrawBox box = given.empty() ? around_origin : given;
  const glm::dvec3 size(box.max - box.min);
  const double extent = std::max(ground_extent(size), 1e-6);
  Ground ground;
  ground.step = ground_step(extent / space.scale).size();
  ground.step_scaled = ground.step * space.scale;
  ground.height = box.min.y - below * extent;
  ground.x = 0.5 * (double{box.min.x} + box.max.x);
  ground.z = 0.5 * (double{box.min.z} + box.max.z);
  ground.reach = reaches * extent;
  const auto lines = [&](double middle, double origin, double& from_tenth, double& from_zero) {
    from_zero = (middle / space.scale + origin) / ground.step;
    from_tenth = from_zero - 10 * std::round(from_zero / 10);
  };
  lines(ground.x, space.origin.x, ground.line_x, ground.zero_x);
  lines(ground.z, space.origin.z, ground.line_z, ground.zero_z);
  return ground;
}

void GridPass::draw(const Frame& frame, const Ground& ground) const {
  const Palette& colours = palette(frame.settings.theme);
  use_for(frame, program_);
  program_.set("middle", glm::vec3(ground.x, ground.height, ground.z));
  program_.set("reach", static_cast<float>(ground.reach));
  program_.set("step_size", static_cast<float>(ground.step_scaled));
  program_.set("line_at_middle", glm::vec2(ground.line_x, ground.line_z));
  // Far from there they are of no use, and too large for single precision.
  program_.set("zero_at_middle", glm::vec2(std::clamp(ground.zero_x, -1e4, 1e4), std::clamp(ground.zero_z, -1e4, 1e4)));
  program_.set("line_colour", unit(colours.grid));
  program_.set("x_colour", glm::vec3(unit(colours.axes[0])));
  program_.set("z_colour", glm::vec3(unit(colours.axes[2])));
  glBindVertexArray(no_attributes_.id());
  set_drawing(Blend::over, GL_LEQUAL);
  glEnable(GL_DEPTH_CLAMP);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glDisable(GL_DEPTH_CLAMP);
}

}  // namespace ryosen
