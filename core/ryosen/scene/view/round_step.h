// Steps of round lengths: 1, 2 or 5 times a power of ten, such as those of the lines on the ground.
#pragma once

#include <glm/vec3.hpp>

namespace ryosen {

struct RoundStep {
  int leading = 1;
  int power = 0;  // of ten

  double size() const { return times(1); }
  // The decimal number that so many of them are, rounded once.
  double times(double count) const;
  double nearest_to(double value) const;
  RoundStep tenth() const { return {leading, power - 1}; }
};

// The largest that is no larger; the length is positive. What rounding has taken from it does not count.
RoundStep round_step(double length);

// How large what has these extents counts for the ground below it, and how far apart the lines there are.
double ground_extent(const glm::dvec3& size);
RoundStep ground_step(double extent);

}  // namespace ryosen
