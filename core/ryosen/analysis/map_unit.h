// Units of measured values.
#pragma once

#include <cstdint>
#include <string_view>

namespace ryosen {

enum class MapUnit : std::uint8_t { none, length, area, degrees, per_length, per_area };  // of the unit of the file

// Behind the number: a degree sign; empty for plain numbers and for lengths, which are in the unit of the file.
inline std::string_view sign_of(MapUnit unit) { return unit == MapUnit::degrees ? "°" : ""; }

}  // namespace ryosen
