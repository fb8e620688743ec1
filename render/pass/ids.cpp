#include "render/pass/ids.h"

#include "render/pass/surface.h"

namespace ryosen {
namespace {

constexpr PixelFormat id_formats[] = {PixelFormat::r32ui, PixelFormat::r32f};

}  // namespace

Result<IdsPass> IdsPass::make() {
  Result<Program> program = Program::make("ids.vert", "ids.frag");
  if (!program) return program.failure();
  return IdsPass(std::move(*program));
}

IdsPass::IdsPass(Program program)
    : program_(std::move(program)), no_attributes_("ids"), target_("ids", id_formats, true) {
  MeshBuffers::set_units(program_);
}

const Framebuffer& IdsPass::draw(const Frame& frame, const MeshBuffers& mesh, std::span<const std::uint32_t> clusters) {
  target_.resize(frame.size);
  target_.bind(frame.rect);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  constexpr GLuint no_triangle[4] = {0, 0, 0, 0};
  constexpr GLfloat no_distance[4] = {0, 0, 0, 0};
  constexpr GLfloat farthest = 1;
  glClearBufferuiv(GL_COLOR, 0, no_triangle);
  glClearBufferfv(GL_COLOR, 1, no_distance);
  glClearBufferfv(GL_DEPTH, 0, &farthest);
  program_.use();
  program_.set("clip_from_buffer", frame.clip_from_buffer);
  program_.set("view_from_buffer", frame.view_from_buffer);
  mesh.bind();
  glBindVertexArray(no_attributes_.id());
  draw_clusters(program_, frame, mesh, clusters, 1);
  return target_;
}

}  // namespace ryosen
