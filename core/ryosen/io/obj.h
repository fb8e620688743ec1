// Reader and writer for Wavefront OBJ.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ryosen/io/format.h"

namespace ryosen {

// Reads an OBJ file. `path` only gives the folder in which to look for material libraries (they are never opened) and
// may be empty. An unreadable number is an error with line and column; unusable faces are quarantined, texture and
// normal indices out of range are dropped, non-finite numbers are kept: each with a warning. Forward references to
// vertices are allowed. Cost: O(bytes), one pass.
Result<MeshFile> read_obj(std::string_view bytes, const std::filesystem::path& path);

// Splits the bytes into pieces of about `piece_bytes`, extended to the next line feed that does not continue a line. At
// least one piece; only a single piece may be empty. O(number of pieces) for ordinary lines.
std::vector<std::string_view> cut_obj(std::string_view bytes, std::size_t piece_bytes);

// As read_obj on the concatenation of the pieces from cut_obj; the result does not depend on the cuts or threads. Each
// piece is parsed independently; one that depends on earlier lines or needs a message is parsed again sequentially.
// With several pieces the file must have fewer than 2^32 - 1 bytes.
Result<MeshFile> read_obj_pieces(std::span<const std::string_view> pieces, const std::filesystem::path& path,
                                 unsigned threads);

// Whether it starts with OBJ lines; not sure if these are only names.
Likeness looks_like_obj(std::string_view head, std::uint64_t size);

// Serialises to OBJ; read_obj restores the same polygons, values and names bitwise. Quarantined faces are written in
// their place and are quarantined again for the same cause.
std::string write_obj(const MeshFile& file);

// Relative vertex indices that resolve below this are clamped to it, so that converting them back cannot overflow.
inline constexpr std::int64_t obj_least_vertex = -(std::int64_t{1} << 62);

}  // namespace ryosen
