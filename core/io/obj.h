// Wavefront OBJ.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/io/format.h"

namespace ryosen {

// Reads an OBJ file. `path` only tells the folder in which material libraries are looked for (they are never opened)
// and may be empty. An unreadable number is an error with line and column; faces that cannot be used go to the
// quarantine, texture and normal indices out of range are dropped, numbers that are not finite stay: each with a
// warning. An index may name a vertex that comes later in the file. Cost: O(bytes), one pass.
Result<MeshFile> read_obj(std::string_view bytes, const std::filesystem::path& path);

// Whether lines of OBJ come first; not sure while these are names alone.
Likeness looks_like_obj(std::string_view head, std::uint64_t size);

// The bytes of an OBJ file from which read_obj makes the same polygons, values and names, to the last bit. Faces in
// quarantine are written in their place and are quarantined again for the same cause.
std::string write_obj(const MeshFile& file);

// Numbers of vertices that count back from the end, further than this before the first one, are read as this one, so that
// counting back from another end does not overflow.
inline constexpr std::int64_t obj_least_vertex = -(std::int64_t{1} << 62);

}  // namespace ryosen
