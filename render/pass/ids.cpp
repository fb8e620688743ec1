#include "render/pass/ids.h"

#include "render/pass/surface.h"

namespace ryosen {
namespace {

constexpr PixelFormat id_formats[] = {PixelFormat::r32ui, PixelFormat::r32f};

}  // namespace

IdsPass::IdsPass(std::optional<Failure>& failure)
    : program_(failure, "ids.vert", "ids.frag"), target_("ids", id_formats, true) {
  if (failure) return;
  MeshBuffers::set_units(program_);
}

const Framebuffer& IdsPass::draw(const Frame& frame, const MeshBuffers& mesh, std::span<const std::uint32_t> clusters) {
  target_.resize(frame.size);
  target_.bind(frame.rect);
  set_drawing(Blend::none, GL_LESS, true);
  constexpr GLuint no_triangle[4] = {0, 0, 0, 0};
  constexpr GLfloat no_distance[4] = {0, 0, 0, 0};
  constexpr GLfloat farthest = 1;
  glClearBufferuiv(GL_COLOR, 0, no_triangle);
  glClearBufferfv(GL_COLOR, 1, no_distance);
  glClearBufferfv(GL_DEPTH, 0, &farthest);
  use_for(frame, program_);
  mesh.bind();
  glBindVertexArray(no_attributes_.id());
  draw_clusters(program_, frame, mesh, clusters, 1);
  return target_;
}

}  // namespace ryosen
