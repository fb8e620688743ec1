// The colour type of the renderer.
#pragma once

#include <array>
#include <cstdint>

namespace ryosen {

// Red, green, blue, alpha from 0 to 255, sRGB; straight (not premultiplied) alpha.
using Rgba = std::array<std::uint8_t, 4>;

constexpr Rgba rgb(std::uint32_t hex, std::uint8_t alpha = 255) {
  return {static_cast<std::uint8_t>(hex >> 16), static_cast<std::uint8_t>(hex >> 8), static_cast<std::uint8_t>(hex),
          alpha};
}

constexpr Rgba with_alpha(Rgba colour, std::uint8_t alpha) { return {colour[0], colour[1], colour[2], alpha}; }

}  // namespace ryosen
