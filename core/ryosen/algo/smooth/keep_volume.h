// Giving smoothed parts their volume back.
#pragma once

#include "ryosen/algo/smooth/laplacian.h"

namespace ryosen::smooth {

struct KeptVolume {
  std::size_t parts = 0;         // got their volume back, but for 1e-9 of it
  std::size_t open_parts = 0;    // have none: they are not closed, or not consistently oriented
  std::size_t failed_parts = 0;  // no length up to their size gives it back; they stay as they are
};

// For each closed part of the mesh of which a point has a share, moves its points along their normals, by their shares
// and a length of the part's own, so that its volume is what it was at `before` [Desbrun99]. Points without a share
// stay. Faces count as in the figures: as cones over their sides from the mean of their corners. `before` and `places`
// are those of the mesh times the scale. O(n).
KeptVolume keep_volume(const Mesh& mesh, double scale, std::span<const double> shares, const Places& before,
                       Places& places);

}  // namespace ryosen::smooth
