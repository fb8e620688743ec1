// Where the clusters of a mesh lie in a picture: their order from front to back and their screen bounds.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <span>
#include <vector>

#include "render/mesh_buffers.h"
#include "render/occlusion.h"

namespace ryosen {

// Refers to the clusters by number; they are passed to each call as they are then.
class ClusterPlaces {
 public:
  // Places all clusters in a view of this size. The order is kept until the next call: of two coincident triangles the
  // first one drawn is visible.
  void place_all(std::span<const Cluster> clusters, const glm::dmat4& view_from_buffer,
                 const glm::mat4& clip_from_buffer, Size size);
  // Places those that have changed; new ones come last in the order.
  void place(std::span<const Cluster> clusters, std::span<const std::uint32_t> changed,
             const glm::mat4& clip_from_buffer, Size size);

  // Those with a part in the rectangle, front to back, so that the depth test rejects occluded fragments before shading.
  std::vector<std::uint32_t> inside(const PixelRect& rect) const;
  std::size_t triangles_inside(std::span<const Cluster> clusters, const PixelRect& rect) const;
  // Takes away those that are hidden for certain, and returns how many triangles they have; a picture pixel is `scale`
  // rendered ones wide.
  std::size_t remove_hidden(std::span<const Cluster> clusters, const Occlusion& occlusion,
                            const glm::mat4& clip_from_buffer, int scale, std::vector<std::uint32_t>& numbers) const;

 private:
  std::vector<std::uint32_t> order_;  // front to back
  std::vector<PixelRect> places_;     // by number, in picture pixels
};

}  // namespace ryosen
