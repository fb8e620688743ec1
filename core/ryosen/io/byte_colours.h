// Colours as bytes: the numbers that mean one, and the colours in OFF text files, which range over 0..255 or 0..1:
// vertex colours are bytes if any component exceeds 1; face colours are decided per face.
#pragma once

#include <cstdint>
#include <optional>

#include "ryosen/io/mesh_file.h"

namespace ryosen {

inline constexpr double byte_scale = 255.0;

// The byte-scale number that reading converts back to the same component, integral if possible.
double as_byte(double component);
// The byte n that a component from 0 to 1 means: n / 255, printed with the decimals of the component, at least four,
// gives the component again.
std::optional<std::uint8_t> byte_meant(double component);
// Whether the vertex colours must be written as bytes to be read back: because a component exceeds 1, or because the
// file had bytes and they are still recognisable. O(colours).
bool are_byte_colours(const MeshFile& file);
// The number of vertex and face colours that do not round-trip, because of rounding or range; O(colours).
std::uint64_t count_rounded_colours(const MeshFile& file);

// How a face colour is written. The text determines its scale: integers are bytes, as are all components of a colour
// with one above 1; others range over 0..1.
enum class ColourForm { bytes, large_bytes, reals };
// For a face with three or four components: bytes if the file had bytes and they are exact.
ColourForm form_of_face_colour(const FaceColours& colours, std::size_t face);

}  // namespace ryosen
