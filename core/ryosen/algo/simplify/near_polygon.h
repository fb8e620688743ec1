// Convex polygons of few corners, by whose parts proofs of nearness go.
#pragma once

#include <array>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <utility>

#include "ryosen/geometry/box.h"

namespace ryosen {

template <std::size_t most_corners>
struct NearPolygon {
  std::array<glm::dvec3, most_corners> corners;
  std::size_t count = 0;

  void add(const glm::dvec3& corner) { corners[count++] = corner; }
  // From corner i to the next one.
  double side_length(std::size_t i) const { return glm::length(corners[(i + 1) % count] - corners[i]); }
  std::size_t longest_side() const {
    std::size_t longest = 0;
    for (std::size_t i = 1; i < count; ++i)
      if (side_length(i) > side_length(longest)) longest = i;
    return longest;
  }
  Box box() const {
    Box box;
    for (std::size_t i = 0; i < count; ++i) box.add(corners[i]);
    return box;
  }
  // Both parts of it, from the middle of the longest side to the corner across.
  std::pair<NearPolygon, NearPolygon> halves() const {
    const std::size_t longest = longest_side(), across = longest + 1 + count / 2;
    const glm::dvec3 middle = 0.5 * corners[longest] + 0.5 * corners[(longest + 1) % count];
    std::pair<NearPolygon, NearPolygon> halves;
    halves.first.add(middle);
    for (std::size_t i = longest + 1; i <= across; ++i) halves.first.add(corners[i % count]);
    halves.second.add(middle);
    for (std::size_t i = across; i <= longest + count; ++i) halves.second.add(corners[i % count]);
    return halves;
  }
};

}  // namespace ryosen
