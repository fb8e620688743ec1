// Lists of numbers that shaders read, a new one for each draw: which of many things are drawn, all of them at once. So
// many draws of a few each would cost more than what they draw.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "render/gl/buffer.h"

namespace ryosen {

class NumberLists {
 public:
  // Writes a list and binds it, as texels of one number each, to a texture unit.
  void bind(std::span<const std::uint32_t> numbers, GLuint unit) {
    TexelArray<std::uint32_t>& list = lists_[next_++ % lists_.size()];
    glActiveTexture(GL_TEXTURE0 + unit);  // where it grows it is bound to the one that is active
    list.write(0, numbers);
    list.bind(unit);
  }

 private:
  // One that is still being read would be waited for, so they take turns.
  std::array<TexelArray<std::uint32_t>, 4> lists_{
      TexelArray<std::uint32_t>{"numbers", GL_R32UI}, TexelArray<std::uint32_t>{"numbers", GL_R32UI},
      TexelArray<std::uint32_t>{"numbers", GL_R32UI}, TexelArray<std::uint32_t>{"numbers", GL_R32UI}};
  std::size_t next_ = 0;
};

}  // namespace ryosen
