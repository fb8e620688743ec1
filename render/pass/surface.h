// Draws the triangles of a mesh: both sides, flat or smooth, with the wireframe and the tints of faces. Lighting is
// done per triangle or per corner, because a software renderer has to pay for every pixel.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "render/gl/program.h"
#include "render/mesh_buffers.h"
#include "render/pass/frame.h"
#include "ryosen/base/enum_table.h"
#include "ryosen/base/result.h"
#include "ryosen/scene/view/view_settings.h"

namespace ryosen {

class SurfacePass {
 public:
  explicit SurfacePass(std::optional<Failure>& failure);

  // Draws these clusters in order into the bound framebuffer.
  void draw(const Frame& frame, const MeshBuffers& mesh, std::span<const std::uint32_t> clusters,
            std::span<const DrawnTint> tints) const;

 private:
  // A shader each: a software renderer pays for what is not looked at.
  struct Programs {
    Programs(std::optional<Failure>& failure, const std::string& defines);

    Program surface, painted, tint;
  };

  std::array<Programs, enum_count<Shading>> programs_;
  VertexArray no_attributes_{"surface"};
};

// Tells a program the tints of faces, by the colours that `convert` makes of theirs.
void set_tints(const Program& program, std::span<const DrawnTint> tints, glm::vec4 (*convert)(Rgba));

// Issues the triangles of clusters, or every so many-th, in one draw, and tells the shader in use (mesh.glsl); a vertex
// array must be bound. `thinning` divides the size of a cluster. Of what the frame's plane cuts, what is kept.
void draw_clusters(const Program& program, const Frame& frame, const MeshBuffers& mesh,
                   std::span<const std::uint32_t> clusters, std::uint32_t thinning);

}  // namespace ryosen
