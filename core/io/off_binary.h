// The binary form of OFF.
#pragma once

#include <cstdint>
#include <string_view>

#include "core/base/result.h"
#include "core/io/off_builder.h"

namespace ryosen {

// Reads what follows the line with BINARY, from `start` on. The byte order, and whether each face is followed by a
// number of colour values as the format's description has it, are not told by the file; the reading counts in which
// all of it makes sense and the least is left over.
Result<MeshFile> read_off_binary(std::string_view bytes, std::uint64_t start, OffKind kind);

}  // namespace ryosen
