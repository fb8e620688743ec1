// Colours in text that may count from 0 to 255 instead of from 0 to 1: in OFF those of the vertices do where any of
// their numbers is above one; each face tells for itself.
#pragma once

#include "core/io/mesh_file.h"

namespace ryosen {

inline constexpr double byte_scale = 255.0;

// The number that reading divides back into the component, a whole one if there is.
double as_byte(double component);
// Whether the vertex colours have to be written so to be read again: because one is above one, or because the file came
// so and its numbers still show it. O(colours).
bool are_byte_colours(const MeshFile& file);
// How many colours of vertices and faces come back as others, by a rounding or because they are too large; O(colours).
std::uint64_t count_rounded_colours(const MeshFile& file);

// How the colour of a face is written, which says by itself what its numbers are: whole numbers are bytes, as are all of
// a colour with one above one; any others go from 0 to 1.
enum class ColourForm { bytes, large_bytes, reals };
// Of a face with three or four numbers: bytes where the file came with such and they are the numbers' own.
ColourForm form_of_face_colour(const FaceColours& colours, std::size_t face);

}  // namespace ryosen
