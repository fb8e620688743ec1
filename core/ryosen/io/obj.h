// Reader and writer for Wavefront OBJ.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "ryosen/io/format.h"

namespace ryosen {

// Reads an OBJ file. `path` only gives the folder in which to look for material libraries (they are never opened) and
// may be empty. An unreadable number is an error with line and column; unusable faces are quarantined, texture and
// normal indices out of range are dropped, non-finite numbers are kept: each with a warning. Forward references to
// vertices are allowed. Cost: O(bytes), one pass.
Result<MeshFile> read_obj(std::string_view bytes, const std::filesystem::path& path);

// Whether it starts with OBJ lines; not sure if these are only names.
Likeness looks_like_obj(std::string_view head, std::uint64_t size);

// Serialises to OBJ; read_obj restores the same polygons, values and names bitwise. Quarantined faces are written in
// their place and are quarantined again for the same cause.
std::string write_obj(const MeshFile& file);

// Relative vertex indices that resolve below this are clamped to it, so that converting them back cannot overflow.
inline constexpr std::int64_t obj_least_vertex = -(std::int64_t{1} << 62);

}  // namespace ryosen
