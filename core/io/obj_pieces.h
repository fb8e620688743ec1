// An OBJ file in pieces that are read at the same time.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/io/mesh_file.h"

namespace ryosen {

// The bytes in pieces of `piece_bytes` and what is left of the line there: cut only behind a line feed that ends a line
// which goes on nowhere. At least one piece, none is empty but the only one. O(number of pieces) for usual lines.
std::vector<std::string_view> cut_obj(std::string_view bytes, std::size_t piece_bytes);

// As read_obj of the file, whose consecutive pieces by cut_obj these are; what it gives does not depend on the cuts or
// the threads. Each piece has a parser of its own. One whose lines need those before it, or a message, is read again in
// its turn. The file has fewer than 2^32 - 1 bytes if there are several pieces.
Result<MeshFile> read_obj_pieces(std::span<const std::string_view> pieces, const std::filesystem::path& path,
                                 unsigned threads);

}  // namespace ryosen
