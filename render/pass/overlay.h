// Draws lines, points and ghosts over the surface, as quads of a width in pixels with smooth edges.
#pragma once

#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "render/gl/buffer.h"
#include "render/gl/program.h"
#include "render/gl/vertex_runs.h"
#include "render/mesh_buffers.h"
#include "render/overlay.h"
#include "render/pass/frame.h"

namespace ryosen {

// A ghost triangle, line or point as overlay.vert reads it: three places in buffer space with the size in pixels, the
// strength where hidden, and kind + 4 * style in their fourth numbers; then the colour from 0 to 1.
struct OverlayElement {
  glm::vec4 texels[4];
  friend bool operator==(const OverlayElement&, const OverlayElement&) = default;

  DrawBox box() const;
  float reach_px() const;  // how far it may be drawn beside its box
};

// A box in buffer space, and how many pixels beside it are touched too.
struct TouchedBox {
  DrawBox box;
  float reach_px = 0;
};

// The drawn copy of one overlay.
class OverlayBuffer {
 public:
  explicit OverlayBuffer(const char* label) : gpu_(label, GL_RGBA32F) {}

  // Replaces the content. What was and is no longer there, and what is newly there, is appended to `touched`, found by
  // comparing from both ends; elements that stay cost a comparison only. Elements at non-finite places are left out.
  void set(const Overlay& overlay, const BufferSpace& space, std::vector<TouchedBox>& touched);

  void bind(GLuint unit) const { gpu_.bind(unit); }
  // Consecutive elements, as many as one group holds, with the box around them.
  struct Group {
    TouchedBox bounds;
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    bool shows_hidden = false;  // some element of it is drawn where the surface hides it
  };
  std::span<const Group> groups() const { return groups_; }
  std::span<const OverlayElement> elements() const { return elements_; }
  DrawBox bounds() const;

 private:
  void regroup(std::size_t first_changed);

  std::vector<OverlayElement> elements_;
  std::vector<Group> groups_;
  TexelArray<OverlayElement> gpu_;
};

class OverlayPass {
 public:
  static Result<OverlayPass> make();

  // Draws what can touch the frame's rectangle: first faintly what the surface hides, then the rest.
  void draw(const Frame& frame, const OverlayBuffer& overlay) const;

 private:
  struct Selection {
    VertexRuns all, behind;  // everything, and what shows where it is hidden
  };
  static Selection select(const Frame& frame, const OverlayBuffer& overlay);

  explicit OverlayPass(Program program);

  Program program_;
  VertexArray no_attributes_;
};

}  // namespace ryosen
