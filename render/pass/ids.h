// The id pass: triangle number and depth at each pixel; the reference for picking in tests.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "render/gl/framebuffer.h"
#include "render/gl/program.h"
#include "render/mesh_buffers.h"
#include "render/pass/frame.h"
#include "ryosen/base/result.h"

namespace ryosen {

class IdsPass {
 public:
  explicit IdsPass(std::optional<Failure>& failure);

  // Draws into its own framebuffer of the frame's size: image 0 is slot + 1 of the triangle, 0 if none; image 1 is the
  // depth along the view direction in buffer space.
  const Framebuffer& draw(const Frame& frame, const MeshBuffers& mesh, std::span<const std::uint32_t> clusters);

 private:
  Program program_;
  VertexArray no_attributes_{"ids"};
  Framebuffer target_;
};

}  // namespace ryosen
