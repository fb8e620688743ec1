#include "render/pass/xray.h"

#include "render/palette.h"
#include "render/pass/surface.h"

namespace ryosen {

XrayPass::XrayPass(std::optional<Failure>& failure)
    : plain_(failure, "xray.vert", "xray.frag"), painted_(failure, "xray.vert", "xray.frag", "#define PAINTED\n") {
  if (failure) return;
  MeshBuffers::set_units(plain_);
  MeshBuffers::set_units(painted_);
}

void XrayPass::draw(const Frame& frame, const MeshBuffers& mesh, std::span<const std::uint32_t> clusters,
                    std::span<const DrawnTint> tints) const {
  const Palette& colours = palette(frame.settings.theme);
  const bool takes_light = frame.settings.theme == Theme::light;
  const Program& program = mesh.paint() == Paint::none ? plain_ : painted_;
  mesh.bind();
  use_for(frame, program);
  if (mesh.paint() != Paint::none) program.set("paints_sides", mesh.paint() == Paint::sides ? 1 : 0);
  program.set("film_colour", glm::vec3(unit(colours.film)));
  program.set("line_colour", glm::vec3(unit(colours.film_wire)));
  program.set("takes_light", takes_light ? 1.0f : 0.0f);
  set_tints(program, tints, unit);
  glBindVertexArray(no_attributes_.id());
  set_drawing(Blend::add);
  // Its coverage is added in either theme: a picture without a background has an alpha channel.
  glBlendEquationSeparate(takes_light ? GL_FUNC_REVERSE_SUBTRACT : GL_FUNC_ADD, GL_FUNC_ADD);
  draw_clusters(program, frame, mesh, clusters, frame.thinning);
  glBlendEquation(GL_FUNC_ADD);
}

}  // namespace ryosen
