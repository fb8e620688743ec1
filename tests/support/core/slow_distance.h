// Distances from triangles by trying everything, in long doubles: what faster answers are judged by.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace ryosen::test {

using SlowTriangle = std::array<glm::dvec3, 3>;

// By solving for the foot of the normal, and trying the sides.
long double slow_distance(const glm::dvec3& p, const SlowTriangle& t);
long double slow_distance(const glm::dvec3& p, const std::vector<SlowTriangle>& triangles);

// Of the points of one surface from another, over the middles of k * k parts of each triangle; `reach` is how far a
// point of a part is at most from its middle.
struct SlowFigures {
  double mean = 0, rms = 0, largest = 0, reach = 0;
};
SlowFigures slow_figures(const std::vector<SlowTriangle>& from, const std::vector<SlowTriangle>& to, int k);

}  // namespace ryosen::test
