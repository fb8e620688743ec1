// What a face is tinted with, besides its light.
#pragma once

#include <cstddef>
#include <cstdint>

#include "render/colour.h"
#include "ryosen/scene/highlights/looks.h"

namespace ryosen {

// A face carries one byte: 0, or the number of its tint from 1 on, or that it is not drawn at all.
inline constexpr std::uint8_t hidden_face = 255;
inline constexpr std::size_t most_tints = 32;

struct DrawnTint {
  Rgba colour{};
  FaceTint tint{};
  friend bool operator==(const DrawnTint&, const DrawnTint&) = default;
};

}  // namespace ryosen
