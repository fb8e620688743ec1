#include "render/pass/surface.h"

#include <string>
#include <vector>

#include "render/gl/vertex_runs.h"
#include "render/pass/linear.h"

namespace ryosen {
namespace {

struct Tint {
  std::uint8_t flag;
  Role role;
  float strength;
};

// In the order of the bits.
constexpr Tint tints[] = {
    {FaceFlag::selected, Role::selected, 0.75f},
    {FaceFlag::hovered, Role::hover, 0.55f},
    {FaceFlag::legal, Role::legal, 0.7f},
    {FaceFlag::refused, Role::refused, 0.75f},
    {FaceFlag::duplicate, Role::duplicate, 0.8f},
    {FaceFlag::degenerate, Role::degenerate, 0.8f},
    {FaceFlag::misoriented, Role::misoriented, 0.7f},
};

void set_light(const Program& program, const Frame& frame) {
  const Palette& colours = palette(frame.theme);
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

void SurfacePass::draw(const Frame& frame, const MeshBuffers& mesh, std::span<const std::uint32_t> clusters) const {
  mesh.bind();
  glBindVertexArray(no_attributes_.id());
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  const Palette& colours = palette(frame.theme);
  set_light(surface_, frame);
  surface_.set("wire_colour", glm::vec3(linear(colours.wire)));
  surface_.set("wire_strength", unit(colours.wire).w);
  draw_clusters(mesh, clusters);

  std::vector<std::uint32_t> flagged;
  for (const std::uint32_t cluster : clusters) {
    if (mesh.clusters()[cluster].flagged) flagged.push_back(cluster);
  }
  if (flagged.empty()) return;
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDepthFunc(GL_EQUAL);
  glDepthMask(GL_FALSE);
  set_light(tint_, frame);
  for (std::size_t bit = 0; bit < std::size(tints); ++bit) {
    glm::vec4 tint = linear(style(tints[bit].role, frame.theme).colour);
    tint.w = tints[bit].strength;
    tint_.set(("tints[" + std::to_string(bit) + "]").c_str(), tint);
  }
  draw_clusters(mesh, flagged);
}

void draw_clusters(const MeshBuffers& mesh, std::span<const std::uint32_t> clusters) {
  VertexRuns runs;
  for (const std::uint32_t number : clusters) {
    const Cluster& cluster = mesh.clusters()[number];
    runs.add(3 * cluster.first, 3 * cluster.count);
  }
  if (!runs.empty()) runs.draw();
}

}  // namespace ryosen
