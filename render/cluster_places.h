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
