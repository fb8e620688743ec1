// The mesh of polygons that are given by coordinates alone.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <map>
#include <utility>

#include "ryosen/indexed/from_indexed.h"

namespace ryosen::forms {

// Corners with equal coordinates are one point, numbered by the first of them; +0 and -0 are equal. `polygons` is a
// range of ranges of places, all finite. O(n log n).
template <class Polygons>
Mesh mesh_from_places(const Polygons& polygons) {
  IndexedMesh list;
  std::map<std::array<double, 3>, std::uint32_t> number;
  for (const auto& polygon : polygons) {
    for (const glm::dvec3& p : polygon) {
      const auto [found, is_new] =
          number.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(list.positions.size()));
      if (is_new) list.positions.push_back(p);
      list.corners.push_back(found->second);
    }
    list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size()));
  }
  return from_indexed(std::move(list));
}

}  // namespace ryosen::forms
