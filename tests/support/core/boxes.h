// Boxes for tests.
#pragma once

#include <algorithm>
#include <glm/vec3.hpp>
#include <vector>

#include "ryosen/indexed/from_indexed.h"
#include "tests/support/core/shapes.h"

namespace ryosen::test {

// Boxes along the axes in one mesh, each of six quads that look outwards, or inwards.
class Boxes {
 public:
  Boxes& add(const glm::dvec3& lowest, const glm::dvec3& highest, bool inwards = false) {
    const auto first = static_cast<std::uint32_t>(source_.positions.size());
    for (const std::uint32_t corner : {0u, 1u, 3u, 2u, 4u, 5u, 7u, 6u})
      source_.positions.emplace_back((corner & 1u) != 0 ? highest.x : lowest.x,
                                     (corner & 2u) != 0 ? highest.y : lowest.y,
                                     (corner & 4u) != 0 ? highest.z : lowest.z);
    for (std::vector<std::uint32_t> face :
         Polygons{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}) {
      if (inwards) std::reverse(face.begin(), face.end());
      for (const std::uint32_t corner : face) source_.corners.push_back(first + corner);
      source_.face_offsets.push_back(static_cast<std::uint32_t>(source_.corners.size()));
    }
    return *this;
  }
  Boxes& cube(double from, double to, bool inwards = false) { return add(glm::dvec3(from), glm::dvec3(to), inwards); }
  const IndexedMesh& source() const { return source_; }
  Mesh mesh() const { return from_indexed(source_); }

 private:
  IndexedMesh source_;
};

}  // namespace ryosen::test
