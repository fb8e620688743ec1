// Draws the triangles of a mesh as films that one sees through, with the wireframe and the tints of faces. Each adds
// its light to a dark ground, or takes it from a light one, in whole steps of a channel: the picture is the same in
// whatever order they are drawn. Nothing is written to the depths, so that no overlay is hidden.
#pragma once

#include <cstdint>
#include <span>

#include "render/gl/program.h"
#include "render/mesh_buffers.h"
#include "render/pass/frame.h"
#include "ryosen/base/result.h"

namespace ryosen {

class XrayPass {
 public:
  explicit XrayPass(std::optional<Failure>& failure);

  // Over the background, which is there already.
  void draw(const Frame& frame, const MeshBuffers& mesh, std::span<const std::uint32_t> clusters,
            std::span<const DrawnTint> tints) const;

 private:
  Program plain_, painted_;
  VertexArray no_attributes_{"xray"};
};

}  // namespace ryosen
