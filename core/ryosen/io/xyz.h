// Reader for lists of points: a line of three numbers each.
#pragma once

#include <filesystem>
#include <string_view>

#include "ryosen/io/format.h"

namespace ryosen {

// Numbers stand apart by blanks, or all of a line by commas or all by semicolons, one of which may end the line. Blank
// lines and what stands behind # are passed over; further numbers of a line are left out with a warning. A line with
// fewer than three numbers, or an unreadable one, such as one with a decimal comma, is an error. A list without a line
// is one of no points. `path` is not used. Cost: O(bytes), one pass.
Result<MeshFile> read_xyz(std::string_view bytes, const std::filesystem::path& path);

// May be where every line has three numbers or more.
Likeness looks_like_xyz(std::string_view head, std::uint64_t size);

}  // namespace ryosen
