// The planes of the triangles that a search asks about one after the other: those of a leaf.
#pragma once

#include <array>
#include <cstdint>

#include "ryosen/analysis/numbered_surface.h"
#include "ryosen/geometry/triangles_meet.h"

namespace ryosen {

// For one thread; refers to the surface.
class LeafPlanes {
 public:
  explicit LeafPlanes(const NumberedSurface& surface) : surface_(surface) { slots_.fill(no_index); }

  // Whether b lies on one side of the plane of a, so that they cannot meet; often false where it does. Quick for the
  // few a that were asked about last.
  bool are_clear(std::uint32_t a, std::uint32_t b) {
    std::size_t i = 0;
    while (i < slots_.size() && slots_[i] != a) ++i;
    if (i == slots_.size()) {
      i = oldest_;
      oldest_ = (oldest_ + 1) % slots_.size();
      slots_[i] = a;
      planes_[i] = TrianglePlane(surface_.triangle(a).places);
    }
    return planes_[i].is_clear_of(surface_.triangle(b).places);
  }

 private:
  const NumberedSurface& surface_;
  std::array<std::uint32_t, 4> slots_;
  std::array<TrianglePlane, 4> planes_;
  std::size_t oldest_ = 0;
};

}  // namespace ryosen
