// The shortest way between points, segments and triangles in space.
#pragma once

#include <glm/vec3.hpp>
#include <span>

namespace ryosen {

struct ShortestWay {
  glm::dvec3 from, to;
  double length;
};

// Between two of these, each given by its one, two or three corners; 0 where they meet. One without length or area
// counts as what its corners span. Coordinates are finite. Rounded.
ShortestWay shortest_way(std::span<const glm::dvec3> a, std::span<const glm::dvec3> b);

}  // namespace ryosen
