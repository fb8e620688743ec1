#include "render/pass/surface.h"

#include <algorithm>
#include <string>
#include <vector>

#include "render/palette.h"
#include "render/pass/linear.h"
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
  program.use();
  program.set("clip_from_buffer", frame.clip_from_buffer);
  program.set("view_from_buffer", frame.view_from_buffer);
  program.set("pixel_scale", frame.size_scale());
  program.set("units_per_pixel", frame.units_per_pixel);
  program.set("perspective", frame.ortho ? 0.0f : 1.0f);
  program.set("front_colour", glm::vec3(linear(colours.front)));
  program.set("back_colour", glm::vec3(linear(colours.back)));
  program.set("key_colour", glm::vec3(linear(colours.key)));
  program.set("fill_colour", glm::vec3(linear(colours.fill)));
  program.set("rim_colour", glm::vec3(linear(colours.rim)));
  pass_settings(program, frame);
}

}  // namespace

Result<SurfacePass> SurfacePass::make() {
  ByShading programs;
  for (const Shading shading : {Shading::flat, Shading::smooth}) {
    const char* const defines = shading == Shading::smooth ? "#define SMOOTH\n" : "";
    Result<Program> surface = Program::make("surface.vert", "surface.frag", defines);
    if (!surface) return surface.failure();
    Result<Program> painted =
        Program::make("surface.vert", "surface.frag", (std::string(defines) + "#define PAINTED\n").c_str());
    if (!painted) return painted.failure();
    Result<Program> tint = Program::make("tint.vert", "tint.frag", defines);
    if (!tint) return tint.failure();
    programs[static_cast<std::size_t>(shading)].emplace(
        Programs{std::move(*surface), std::move(*painted), std::move(*tint)});
  }
  return SurfacePass(std::move(programs));
}

SurfacePass::SurfacePass(ByShading programs) : programs_(std::move(programs)), no_attributes_("surface") {
  for (const std::optional<Programs>& each : programs_) {
    MeshBuffers::set_units(each->surface);
    MeshBuffers::set_units(each->painted);
    MeshBuffers::set_units(each->tint);
  }
}

void SurfacePass::draw(const Frame& frame, const MeshBuffers& mesh, std::span<const std::uint32_t> clusters,
                       std::span<const DrawnTint> tints) const {
  mesh.bind();
  glBindVertexArray(no_attributes_.id());
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  const auto& [plain, painted, tint] = *programs_[static_cast<std::size_t>(frame.settings.shading)];
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
  for (const std::uint32_t cluster : clusters) {
    if (mesh.clusters()[cluster].tinted) tinted.push_back(cluster);
  }
  if (tinted.empty()) return;
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDepthFunc(GL_EQUAL);
  glDepthMask(GL_FALSE);
  set_light(tint, frame);
  for (std::size_t i = 0; i < std::min(tints.size(), most_tints); ++i) {
    const std::string place = "[" + std::to_string(i) + "]";
    glm::vec4 colour = linear(tints[i].colour);
    colour.w = tints[i].tint.strength;
    tint.set(("tints" + place).c_str(), colour);
    tint.set(("patterns" + place).c_str(), static_cast<int>(tints[i].tint.pattern));
  }
  draw_clusters(tint, frame, mesh, tinted, frame.thinning);
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
