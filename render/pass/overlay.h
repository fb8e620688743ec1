// The overlay pass: draws lines, points and ghosts as antialiased screen-space geometry.
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "render/gl/buffer.h"
#include "render/gl/program.h"
#include "render/mesh_buffers.h"
#include "render/overlay.h"
#include "render/pass/frame.h"
#include "ryosen/base/result.h"

namespace ryosen {

// A ghost triangle, line or point in the layout of overlay.vert: three positions in buffer space, with the size in
// pixels, the opacity where occluded, and kind + 4 * style in w; then the colour, 0 to 1. The second position of a
// point is as far from the first as it has room.
struct OverlayElement {
  glm::vec4 texels[4];
  friend bool operator==(const OverlayElement&, const OverlayElement&) = default;

  // Its ends, the place of a point, or the corners of a ghost.
  std::span<const glm::vec4> corners() const;
  DrawBox box() const;
  float length() const;    // of a line, in buffer space
  float reach_px() const;  // how far in pixels it may extend beyond its box, at display scale 1
};

// A bounding box in buffer space, and a margin around its projection in pixels at display scale 1.
struct TouchedBox {
  DrawBox box;
  float reach_px = 0;
};

// The GPU copy of one overlay, or of its numbered parts.
class OverlayBuffer {
 public:
  explicit OverlayBuffer(const char* label) : gpu_(label, GL_RGBA32F) {}

  // Replaces the content. Appends the boxes of removed and added elements to `touched`; unchanged elements cost only a
  // comparison. Elements at non-finite positions are omitted.
  void set(const Overlay& overlay, const BufferSpace& space, std::vector<TouchedBox>& touched);
  // Replaces one part, at the cost of that part. The drawing order does not depend on the order of calls: ghosts of all
  // parts first, then lines, then points, each by part number.
  void set_part(std::uint32_t part, const Overlay& overlay, const BufferSpace& space, std::vector<TouchedBox>& touched);

  void bind(GLuint unit) const { gpu_.bind(unit); }
  // Consecutive elements of one kind and part, with their bounding box.
  struct Group {
    std::uint32_t part = 0;
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    std::uint32_t room = 0;
    TouchedBox bounds;
    float length = 0;           // of a line of it, in buffer space, in the mean
    bool thins_out = false;     // all are lines that do
    bool shows_hidden = false;  // some element is visible where the surface occludes it
    mutable bool is_placed = false, has_placed_elements = false;
    mutable PixelRect place;
  };
  // Calls visit(group) in drawing order.
  template <class Visit>
  void for_each_group(Visit visit) const {
    for (const std::vector<Group>& groups : groups_)
      for (const Group& group : groups) visit(group);
  }
  DrawBox bounds() const;
  bool has_elements() const;
  void reserve(std::size_t elements);

  // About how many elements are drawn in a rectangle of the picture, as if those of a group were even over it, and how
  // many pixels they cover there together. Costs the groups.
  struct Share {
    double elements = 0, pixels = 0;
  };
  Share share_inside(const Frame& whole, const PixelRect& rect) const;

  // The bounding rectangle of a group or element in a picture of the given size. Cached until forget_places().
  const PixelRect& place(const Group& group, const glm::mat4& clip_from_buffer, Size size) const;
  const PixelRect& place(const Group& group, std::uint32_t element, const glm::mat4& clip_from_buffer, Size size) const;
  // Call it when the camera or the size has changed.
  void forget_places();
  // That of Frame; all places are forgotten with it.
  void set_display_scale(float scale);

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
  float display_scale_ = 1;
  TexelArray<OverlayElement> gpu_;
};

class OverlayPass {
 public:
  explicit OverlayPass(std::optional<Failure>& failure);

  // Draws what can touch the frame's rectangle: first the occluded parts, faintly, then the visible ones. What belongs
  // to the mesh is cut as that is. Where the surface is thinned, so are lines that thin out.
  enum class Of { mesh, view };
  void draw(const Frame& frame, const OverlayBuffer& overlay, Of of = Of::mesh);

 private:
  // The elements that can touch it, in drawing order; before them, once more, those that are visible where occluded.
  struct Selection {
    std::vector<std::uint32_t> numbers;
    std::size_t behind = 0;
  };
  static Selection select(const Frame& frame, const OverlayBuffer& overlay);

  Program program_;
  VertexArray no_attributes_{"overlay"};
  NumberLists drawn_;
};

}  // namespace ryosen
