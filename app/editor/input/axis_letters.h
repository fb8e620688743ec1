// The letters of the axes as strokes, so that they are drawn as lines are.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

namespace ryosen {

// From a to b, from -1 to 1 each way, y up.
struct LetterStroke {
  glm::dvec2 a, b;
};
// X, Y or Z of the axes 0, 1 and 2.
const std::vector<LetterStroke>& axis_letter(int axis);

}  // namespace ryosen
