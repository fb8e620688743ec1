#include "render/pass/xray.h"

#include <algorithm>
#include <string>

#include "render/palette.h"
#include "render/pass/linear.h"
#include "render/pass/surface.h"

namespace ryosen {

Result<XrayPass> XrayPass::make() {
  Result<Program> plain = Program::make("xray.vert", "xray.frag");
  if (!plain) return plain.failure();
  Result<Program> painted = Program::make("xray.vert", "xray.frag", "#define PAINTED\n");
  if (!painted) return painted.failure();
  return XrayPass(std::move(*plain), std::move(*painted));
}

XrayPass::XrayPass(Program plain, Program painted)
    : plain_(std::move(plain)), painted_(std::move(painted)), no_attributes_("xray") {
  MeshBuffers::set_units(plain_);
  MeshBuffers::set_units(painted_);
}

void XrayPass::draw(const Frame& frame, const MeshBuffers& mesh, std::span<const std::uint32_t> clusters,
                    std::span<const DrawnTint> tints) const {
  const Palette& colours = palette(frame.settings.theme);
  const bool takes_light = frame.settings.theme == Theme::light;
  const Program& program = mesh.paint() == Paint::none ? plain_ : painted_;
  mesh.bind();
  program.use();
  pass_settings(program, frame);
  if (mesh.paint() != Paint::none) program.set("paints_sides", mesh.paint() == Paint::sides ? 1 : 0);
  program.set("clip_from_buffer", frame.clip_from_buffer);
  program.set("view_from_buffer", frame.view_from_buffer);
  program.set("pixel_scale", frame.size_scale());
  program.set("units_per_pixel", frame.units_per_pixel);
  program.set("perspective", frame.ortho ? 0.0f : 1.0f);
  program.set("film_colour", glm::vec3(unit(colours.film)));
  program.set("line_colour", glm::vec3(unit(colours.film_wire)));
  program.set("takes_light", takes_light ? 1.0f : 0.0f);
  for (std::size_t i = 0; i < std::min(tints.size(), most_tints); ++i) {
    const std::string place = "[" + std::to_string(i) + "]";
    glm::vec4 colour = unit(tints[i].colour);
    colour.w = tints[i].tint.strength;
    program.set(("tints" + place).c_str(), colour);
    program.set(("patterns" + place).c_str(), static_cast<int>(tints[i].tint.pattern));
  }
  glBindVertexArray(no_attributes_.id());
  glDisable(GL_CULL_FACE);
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  // Its coverage is added in either theme: a picture without a background has an alpha channel.
  glBlendEquationSeparate(takes_light ? GL_FUNC_REVERSE_SUBTRACT : GL_FUNC_ADD, GL_FUNC_ADD);
  draw_clusters(program, frame, mesh, clusters, frame.thinning);
  glBlendEquation(GL_FUNC_ADD);
}

}  // namespace ryosen
