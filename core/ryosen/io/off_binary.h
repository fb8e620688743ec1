// Reader for binary OFF.
#pragma once

#include <cstdint>
#include <string_view>

#include "ryosen/base/result.h"
#include "ryosen/io/off_builder.h"

namespace ryosen {

// Reads the data after the BINARY line, from `start` on. The byte order, and whether each face is followed by a colour
// count as in the format's specification, are not stored in the file: the interpretation that is consistent and leaves
// the fewest bytes over is used.
Result<MeshFile> read_off_binary(std::string_view bytes, std::uint64_t start, OffKind kind);

}  // namespace ryosen
