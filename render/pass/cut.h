// The cut pass: a line along which the clipping plane cuts the surface.
#pragma once

#include <cstdint>
#include <span>

#include "render/gl/program.h"
#include "render/mesh_buffers.h"
#include "render/pass/frame.h"
#include "ryosen/base/result.h"

namespace ryosen {

class CutPass {
 public:
  explicit CutPass(std::optional<Failure>& failure);

  // Over the surface of these clusters, which is there already; nothing where the frame is not cut.
  void draw(const Frame& frame, const MeshBuffers& mesh, std::span<const std::uint32_t> clusters) const;

 private:
  Program program_;
  VertexArray no_attributes_{"cut"};
};

}  // namespace ryosen
