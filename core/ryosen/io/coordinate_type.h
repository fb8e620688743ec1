// The type of number in which a file has its coordinates.
#pragma once

#include <optional>

#include "ryosen/io/mesh_file.h"

namespace ryosen {

// Whether the coordinates are of type float: those of a binary STL file, and of a PLY file whose properties are. A
// binary PLY file with other types has none. Not known for texts, whose digits alone tell it, and other files.
std::optional<bool> holds_float_coordinates(const MeshFile& file);

}  // namespace ryosen
