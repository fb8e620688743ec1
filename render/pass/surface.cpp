#include "render/pass/surface.h"

#include <algorithm>
#include <string>
#include <vector>

#include "render/palette.h"
#include "ryosen/base/enum_table.h"

namespace ryosen {
namespace {

static_assert(MeshBuffers::cluster_size == 128, "as in mesh.glsl");
// As in tint.frag.
static_assert(enum_count<FacePattern> == 5 && static_cast<int>(FacePattern::diagonal) == 1 &&
              static_cast<int>(FacePattern::chessboard) == 2 && static_cast<int>(FacePattern::horizontal) == 3 &&
              static_cast<int>(FacePattern::bars) == 4);

void set_light(const Program& program, const Frame& frame) {
  const Palette& colours = palette(frame.settings.theme);
  use_for(frame, program);
  program.set("front_colour", glm::vec3(linear(colours.front)));
  program.set("back_colour", glm::vec3(linear(colours.back)));
  program.set("key_colour", glm::vec3(linear(colours.key)));
  program.set("fill_colour", glm::vec3(linear(colours.fill)));
  program.set("rim_colour", glm::vec3(linear(colours.rim)));
}

}  // namespace

SurfacePass::Programs::Programs(std::optional<Failure>& failure, const std::string& defines)
    : surface(failure, "surface.vert", "surface.frag", defines),
      painted(failure, "surface.vert", "surface.frag", defines + "#define PAINTED\n"),
      tint(failure, "tint.vert", "tint.frag", defines) {
  for (const Program* const program : {&surface, &painted, &tint}) MeshBuffers::set_units(*program);
}

SurfacePass::SurfacePass(std::optional<Failure>& failure)
    : programs_{Programs(failure, ""), Programs(failure, "#define SMOOTH\n")} {}  // in the order of Shading

void SurfacePass::draw(const Frame& frame, const MeshBuffers& mesh, std::span<const std::uint32_t> clusters,
                       std::span<const DrawnTint> tints) const {
  mesh.bind();
  glBindVertexArray(no_attributes_.id());
  set_drawing(Blend::none, GL_LESS, true);
  const auto& [plain, painted, tint] = programs_[static_cast<std::size_t>(frame.settings.shading)];
  const Palette& colours = palette(frame.settings.theme);
  const Program& surface = mesh.paint() == Paint::none ? plain : painted;
  set_light(surface, frame);
  if (mesh.paint() != Paint::none) {
    surface.set("paints_sides", mesh.paint() == Paint::sides ? 1 : 0);
    surface.set("paint_floor", mesh.paint() == Paint::own ? -1.0f : 0.6f);
  }
  surface.set("wire_colour", glm::vec3(linear(colours.wire)));
  surface.set("wire_strength", unit(colours.wire).w);
  draw_clusters(surface, frame, mesh, clusters, frame.thinning);

  std::vector<std::uint32_t> tinted;
  for (const std::uint32_t cluster : clusters)
    if (mesh.clusters()[cluster].tinted) tinted.push_back(cluster);
  if (tinted.empty()) return;
  set_drawing(Blend::over, GL_EQUAL);
  set_light(tint, frame);
  set_tints(tint, tints, linear);
  draw_clusters(tint, frame, mesh, tinted, frame.thinning);
}

void set_tints(const Program& program, std::span<const DrawnTint> tints, glm::vec4 (*convert)(Rgba)) {
  for (std::size_t i = 0; i < std::min(tints.size(), most_tints); ++i) {
    const std::string place = "[" + std::to_string(i) + "]";
    glm::vec4 colour = convert(tints[i].colour);
    colour.w = tints[i].tint.strength;
    program.set(("tints" + place).c_str(), colour);
    program.set(("patterns" + place).c_str(), static_cast<int>(tints[i].tint.pattern));
  }
}

void draw_clusters(const Program& program, const Frame& frame, const MeshBuffers& mesh,
                   std::span<const std::uint32_t> clusters, std::uint32_t thinning) {
  if (clusters.empty()) return;
  program.set("thinning", static_cast<int>(thinning));
  program.set("slots", static_cast<int>(mesh.slots()));
  program.set("clip_plane", frame.clip_plane);
  mesh.bind_clusters(clusters);
  if (frame.is_cut) glEnable(GL_CLIP_DISTANCE0);
  const std::size_t triangles = clusters.size() * (MeshBuffers::cluster_size / thinning);
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(3 * triangles));
  glDisable(GL_CLIP_DISTANCE0);
}

}  // namespace ryosen
