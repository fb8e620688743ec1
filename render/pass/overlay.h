// Draws lines, points and ghosts over the surface, as quads of a width in pixels with smooth edges.
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
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

// The drawn copy of one overlay, or of many numbered parts of one.
class OverlayBuffer {
 public:
  explicit OverlayBuffer(const char* label) : gpu_(label, GL_RGBA32F) {}

  // Replaces the content. What was and is no longer there, and what is newly there, is appended to `touched`; elements
  // that stay cost a comparison only. Elements at non-finite places are left out.
  void set(const Overlay& overlay, const BufferSpace& space, std::vector<TouchedBox>& touched);
  // Replaces one part alone, at the cost of that part. What is drawn does not depend on the order of such calls: ghosts
  // of all parts come first, then lines, then points, each in the order of the parts' numbers.
  void set_part(std::uint32_t part, const Overlay& overlay, const BufferSpace& space, std::vector<TouchedBox>& touched);

  void bind(GLuint unit) const { gpu_.bind(unit); }
  // Consecutive elements of one kind and part, with the box around them.
  struct Group {
    std::uint32_t part = 0;
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    std::uint32_t room = 0;
    TouchedBox bounds;
    bool shows_hidden = false;  // some element of it is drawn where the surface hides it
    mutable bool is_placed = false, has_placed_elements = false;
    mutable PixelRect place;
  };
  // Calls visit(group) in the order of drawing.
  template <class Visit>
  void for_each_group(Visit visit) const {
    for (const std::vector<Group>& groups : groups_)
      for (const Group& group : groups) visit(group);
  }
  DrawBox bounds() const;

  // The pixels of a picture of a size that a group or element can touch. Looked for once, until forget_places().
  const PixelRect& place(const Group& group, const glm::mat4& clip_from_buffer, Size size) const;
  const PixelRect& place(const Group& group, std::uint32_t element, const glm::mat4& clip_from_buffer, Size size) const;
  // When the camera or the size has changed.
  void forget_places();

 private:
  static constexpr std::size_t kinds = 3;  // ghosts, lines, points
  using Elements = std::array<std::vector<OverlayElement>, kinds>;

  static Elements converted(const Overlay& overlay, const BufferSpace& space);
  void put(std::size_t kind, std::uint32_t part, std::span<const OverlayElement> fresh,
           std::vector<TouchedBox>& touched);
  void write(Group& group, std::span<const OverlayElement> fresh, std::size_t from);
  void give_room(Group& group, std::size_t count);
  void close_gaps();

  std::vector<OverlayElement> elements_;  // with gaps between the groups
  mutable std::vector<PixelRect> places_;
  std::array<std::vector<Group>, kinds> groups_;  // ascending by part
  std::size_t unused_ = 0;                        // elements in the gaps
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
