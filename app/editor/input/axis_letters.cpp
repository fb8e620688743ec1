#include "app/editor/input/axis_letters.h"

#include <array>

namespace ryosen {

const std::vector<LetterStroke>& axis_letter(int axis) {
  static const std::array<std::vector<LetterStroke>, 3> letters{{
      {{{-0.8, -1}, {0.8, 1}}, {{-0.8, 1}, {0.8, -1}}},
      {{{-0.8, 1}, {0, 0}}, {{0.8, 1}, {0, 0}}, {{0, 0}, {0, -1}}},
      {{{-0.8, 1}, {0.8, 1}}, {{0.8, 1}, {-0.8, -1}}, {{-0.8, -1}, {0.8, -1}}},
  }};
  return letters[static_cast<std::size_t>(axis)];
}

}  // namespace ryosen
