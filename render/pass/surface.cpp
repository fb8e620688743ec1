#include "render/pass/surface.h"

#include <string>
#include <vector>

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

}  // namespace

Result<SurfacePass> SurfacePass::make() {
  Result<Program> program = Program::make("surface.vert", "surface.frag");
  if (!program) return program.failure();
  return SurfacePass(std::move(*program));
}

SurfacePass::SurfacePass(Program program) : program_(std::move(program)), no_attributes_("surface") {
  program_.use();
  program_.set("positions", 0);
  program_.set("triangles", 1);
  program_.set("face_flags", 2);
}

void SurfacePass::draw(const Frame& frame, const MeshBuffers& mesh, std::span<const std::uint32_t> clusters) const {
  const Palette& colours = palette(frame.theme);
  program_.use();
  program_.set("clip_from_mesh", frame.clip_from_mesh);
  program_.set("view_from_mesh", frame.view_from_mesh);
  program_.set("pixel_scale", frame.pixel_scale);
  program_.set("perspective", frame.ortho ? 0.0f : 1.0f);
  program_.set("front_colour", glm::vec3(linear(colours.front)));
  program_.set("back_colour", glm::vec3(linear(colours.back)));
  program_.set("key_colour", glm::vec3(linear(colours.key)));
  program_.set("fill_colour", glm::vec3(linear(colours.fill)));
  program_.set("rim_colour", glm::vec3(linear(colours.rim)));
  program_.set("wire_colour", glm::vec3(linear(colours.wire)));
  program_.set("wire_strength", unit(colours.wire).w);
  for (std::size_t bit = 0; bit < std::size(tints); ++bit) {
    glm::vec4 tint = linear(style(tints[bit].role, frame.theme).colour);
    tint.w = tints[bit].strength;
    program_.set(("tints[" + std::to_string(bit) + "]").c_str(), tint);
  }
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  mesh.bind();
  glBindVertexArray(no_attributes_.id());
  draw_clusters(mesh, clusters);
}

void draw_clusters(const MeshBuffers& mesh, std::span<const std::uint32_t> clusters) {
  std::vector<GLint> first;
  std::vector<GLsizei> count;
  for (const std::uint32_t number : clusters) {
    const Cluster& cluster = mesh.clusters()[number];
    const auto start = static_cast<GLint>(3 * cluster.first);
    const auto length = static_cast<GLsizei>(3 * cluster.count);
    if (!first.empty() && first.back() + count.back() == start) {
      count.back() += length;
    } else {
      first.push_back(start);
      count.push_back(length);
    }
  }
  if (!first.empty()) glMultiDrawArrays(GL_TRIANGLES, first.data(), count.data(), static_cast<GLsizei>(first.size()));
}

}  // namespace ryosen
