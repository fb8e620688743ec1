// The report of filling holes.
#pragma once

#include <span>

#include "ryosen/algo/repair/find_holes.h"

namespace ryosen {

// Numbers of filled holes, by their patches.
struct FilledHoles {
  std::size_t flat = 0;      // in the plane of the rim, or without bulging
  std::size_t fair = 0;      // continues the surface
  std::size_t unfaired = 0;  // was to be fair, but no fair patch is sound
  std::size_t bare = 0;      // triangles between the corners of the rim, since no finer patch is sound
  std::size_t crossing = 0;  // of all these, the ones that cross something
  std::size_t faces = 0, vertices = 0;
  std::size_t mended = 0;  // faces without area at rims that went before

  std::size_t count() const { return flat + fair + unfaired + bare; }
};

// `holes` are all that there were, with why some stay open.
AlgorithmResult fill_report(const Mesh& mesh, const FilledHoles& filled, std::span<const Hole> holes);

}  // namespace ryosen
