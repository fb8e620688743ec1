#include "render/pass/xray.h"

#include <algorithm>
#include <string>

#include "render/palette.h"
#include "render/pass/linear.h"
#include "render/pass/surface.h"

namespace ryosen {

Result<XrayPass> XrayPass::make() {
  Result<Program> program = Program::make("xray.vert", "xray.frag");
  if (!program) return program.failure();
  return XrayPass(std::move(*program));
}

XrayPass::XrayPass(Program program) : program_(std::move(program)), no_attributes_("xray") {
  MeshBuffers::set_units(program_);
}

void XrayPass::draw(const Frame& frame, const MeshBuffers& mesh, std::span<const std::uint32_t> clusters,
                    std::span<const DrawnTint> tints) const {
  const Palette& colours = palette(frame.settings.theme);
  const bool takes_light = frame.settings.theme == Theme::light;
  mesh.bind();
  program_.use();
  pass_settings(program_, frame);
  program_.set("clip_from_buffer", frame.clip_from_buffer);
  program_.set("view_from_buffer", frame.view_from_buffer);
  program_.set("pixel_scale", frame.pixel_scale);
  program_.set("perspective", frame.ortho ? 0.0f : 1.0f);
  program_.set("film_colour", glm::vec3(unit(colours.film)));
  program_.set("line_colour", glm::vec3(unit(colours.film_wire)));
  program_.set("takes_light", takes_light ? 1.0f : 0.0f);
  for (std::size_t i = 0; i < std::min(tints.size(), most_tints); ++i) {
    const std::string place = "[" + std::to_string(i) + "]";
    glm::vec4 colour = unit(tints[i].colour);
    colour.w = tints[i].tint.strength;
    program_.set(("tints" + place).c_str(), colour);
    program_.set(("patterns" + place).c_str(), static_cast<int>(tints[i].tint.pattern));
  }
  glBindVertexArray(no_attributes_.id());
  glDisable(GL_CULL_FACE);
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  // Its coverage is added in either theme: a picture without a background has an alpha channel.
  glBlendEquationSeparate(takes_light ? GL_FUNC_REVERSE_SUBTRACT : GL_FUNC_ADD, GL_FUNC_ADD);
  draw_clusters(program_, mesh, clusters, frame.thinning);
  glBlendEquation(GL_FUNC_ADD);
}

}  // namespace ryosen
