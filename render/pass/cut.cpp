#include "render/pass/cut.h"

#include <vector>

#include "render/palette.h"
#include "render/pass/surface.h"

namespace ryosen {
namespace {

// Whether the plane goes through a box.
bool meets(const glm::vec4& plane, const DrawBox& box) {
  bool is_kept = false, is_cut_off = false;
  for (std::size_t i = 0; i < 8; ++i)
    (glm::dot(plane, glm::vec4(box.corner(i), 1.0f)) >= 0 ? is_kept : is_cut_off) = true;
  return is_kept && is_cut_off;
}

}  // namespace

CutPass::CutPass(std::optional<Failure>& failure) : program_(failure, "cut.vert", "cut.frag") {
  if (failure) return;
  MeshBuffers::set_units(program_);
}

void CutPass::draw(const Frame& frame, const MeshBuffers& mesh, std::span<const std::uint32_t> clusters) const {
  if (!frame.is_cut) return;
  std::vector<std::uint32_t> met;
  for (const std::uint32_t cluster : clusters)
    if (!mesh.clusters()[cluster].box.empty() && meets(frame.clip_plane, mesh.clusters()[cluster].box))
      met.push_back(cluster);
  if (met.empty()) return;
  mesh.bind();
  use_for(frame, program_);
  program_.set("line_colour", unit(palette(frame.settings.theme).cut));
  glBindVertexArray(no_attributes_.id());
  set_drawing(Blend::over, GL_EQUAL);
  draw_clusters(program_, frame, mesh, met, frame.thinning);
}

}  // namespace ryosen
