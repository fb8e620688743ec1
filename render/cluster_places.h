// Where the clusters of a mesh lie in a picture: their order from front to back, their screen bounds, and which of them
// the surface drawn so far hides.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <span>
#include <vector>

#include "render/gl/framebuffer.h"
#include "render/mesh_buffers.h"
#include "render/screen.h"

namespace ryosen {

// What the surface drawn so far hides for certain, from the depths that it left. Keeps the farthest depth of small
// squares of pixels. Where something farther would be drawn, nothing would be seen of it.
class Occlusion {
 public:
  // Reads the depths of a rectangle; waits for what is being drawn.
  void read(const DrawTarget& drawn, const PixelRect& rect);

  // Whether what lies in the box, and is drawn inside `place`, cannot be seen in the rectangle that was read. Not asked
  // of what reaches in front of the near plane.
  bool hides(const DrawBox& box, const PixelRect& place, const glm::mat4& clip_from_buffer) const;

 private:
  static constexpr int square = 8;  // pixels

  PixelRect rect_;
  int columns_ = 0;
  std::vector<float> depths_;    // of pixels, rows top-down
  std::vector<float> farthest_;  // of squares
};

// Refers to the clusters by number; they are passed to each call as they are then.
class ClusterPlaces {
 public:
  // Places all clusters in a view of this size, so many neighbours as one: where but a part of their triangles are
  // drawn, each by itself costs more than it has to show. The order is kept until the next call: of two coincident
  // triangles the first one drawn is visible.
  void place_all(std::span<const Cluster> clusters, std::uint32_t neighbours, const glm::dmat4& view_from_buffer,
                 const glm::mat4& clip_from_buffer, Size size);
  // Places those that have changed; new ones come last in the order.
  void place(std::span<const Cluster> clusters, std::span<const std::uint32_t> changed,
             const glm::mat4& clip_from_buffer, Size size);

  // Those with a part in the rectangle, front to back, so that the depth test rejects occluded fragments before
  // shading.
  std::vector<std::uint32_t> inside(std::span<const Cluster> clusters, const PixelRect& rect) const;
  std::size_t triangles_inside(std::span<const Cluster> clusters, const PixelRect& rect) const;
  // Takes away those that are hidden for certain, and returns how many triangles they have; a picture pixel is `scale`
  // rendered ones wide.
  std::size_t remove_hidden(std::span<const Cluster> clusters, const Occlusion& occlusion,
                            const glm::mat4& clip_from_buffer, int scale, std::vector<std::uint32_t>& numbers) const;

 private:
  // The clusters of a group, as one.
  DrawBox box_of(std::span<const Cluster> clusters, std::uint32_t group) const;
  std::uint32_t groups_for(std::size_t clusters) const {
    return static_cast<std::uint32_t>((clusters + neighbours_ - 1) / neighbours_);
  }

  std::uint32_t neighbours_ = 1;      // so many successive clusters are a group
  std::vector<std::uint32_t> order_;  // of the groups, front to back
  std::vector<PixelRect> places_;     // of the groups, in picture pixels
};

}  // namespace ryosen
