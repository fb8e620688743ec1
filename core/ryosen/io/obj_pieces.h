// Parallel reading of an OBJ file in pieces.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "ryosen/base/result.h"
#include "ryosen/io/mesh_file.h"

namespace ryosen {

// Splits the bytes into pieces of about `piece_bytes`, extended to the next line feed that does not continue a line. At
// least one piece; only a single piece may be empty. O(number of pieces) for ordinary lines.
std::vector<std::string_view> cut_obj(std::string_view bytes, std::size_t piece_bytes);

// As read_obj on the concatenation of the pieces from cut_obj; the result does not depend on the cuts or threads. Each
// piece is parsed independently; one that depends on earlier lines or needs a message is parsed again sequentially.
// With several pieces the file must have fewer than 2^32 - 1 bytes.
Result<MeshFile> read_obj_pieces(std::span<const std::string_view> pieces, const std::filesystem::path& path,
                                 unsigned threads);

}  // namespace ryosen
