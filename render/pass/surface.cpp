#include "render/pass/surface.h"

#include <algorithm>
#include <string>
#include <vector>

#include "core/base/enum_table.h"
#include "render/gl/vertex_runs.h"
#include "render/palette.h"
#include "render/pass/linear.h"

namespace ryosen {
namespace {

// As in tint.frag.
static_assert(enum_count<FacePattern> == 5 && static_cast<int>(FacePattern::diagonal) == 1 &&
              static_cast<int>(FacePattern::chessboard) == 2 && static_cast<int>(FacePattern::horizontal) == 3 &&
              static_cast<int>(FacePattern::vertical) == 4);

void set_light(const Program& program, const Frame& frame) {
  const Palette& colours = palette(frame.settings.theme);
  program.use();
  program.set("clip_from_buffer", frame.clip_from_buffer);
  program.set("view_from_buffer", frame.view_from_buffer);
  program.set("pixel_scale", frame.pixel_scale);
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
  Result<Program> surface = Program::make("surface.vert", "surface.frag");
  if (!surface) return surface.failure();
  Result<Program> tint = Program::make("tint.vert", "tint.frag");
  if (!tint) return tint.failure();
  return SurfacePass(std::move(*surface), std::move(*tint));
}

SurfacePass::SurfacePass(Program surface, Program tint)
    : surface_(std::move(surface)), tint_(std::move(tint)), no_attributes_("surface") {
  MeshBuffers::set_units(surface_);
  MeshBuffers::set_units(tint_);
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
  const Palette& colours = palette(frame.settings.theme);
  set_light(surface_, frame);
  surface_.set("wire_colour", glm::vec3(linear(colours.wire)));
  surface_.set("wire_strength", unit(colours.wire).w);
  draw_clusters(surface_, mesh, clusters, frame.thinning);

  std::vector<std::uint32_t> tinted;
  for (const std::uint32_t cluster : clusters) {
    if (mesh.clusters()[cluster].tinted) tinted.push_back(cluster);
  }
  if (tinted.empty()) return;
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDepthFunc(GL_EQUAL);
  glDepthMask(GL_FALSE);
  set_light(tint_, frame);
  for (std::size_t i = 0; i < std::min(tints.size(), most_tints); ++i) {
    const std::string place = "[" + std::to_string(i) + "]";
    glm::vec4 colour = linear(tints[i].colour);
    colour.w = tints[i].tint.strength;
    tint_.set(("tints" + place).c_str(), colour);
    tint_.set(("patterns" + place).c_str(), static_cast<int>(tints[i].tint.pattern));
  }
  draw_clusters(tint_, mesh, tinted, frame.thinning);
}

void draw_clusters(const Program& program, const MeshBuffers& mesh, std::span<const std::uint32_t> clusters,
                   std::uint32_t thinning) {
  program.set("thinning", static_cast<int>(thinning));
  VertexRuns runs;
  for (const std::uint32_t number : clusters) {
    const Cluster& cluster = mesh.clusters()[number];
    runs.add(3 * (cluster.first / thinning), 3 * ((cluster.count + thinning - 1) / thinning));
  }
  if (!runs.empty()) runs.draw();
}

}  // namespace ryosen
