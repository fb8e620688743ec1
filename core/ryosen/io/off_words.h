// OFF whose numbers are not laid out line by line.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "ryosen/io/mesh_file.h"

namespace ryosen {

// Reads the text form as nothing but words: the three counts (the first may stand right behind the word OFF), the
// numbers of every vertex, then for every face how many corners it has and these. Where a colour ends words cannot
// tell: those of vertices have all four or all three numbers, faces have none. None unless everything comes out exactly
// at the end of the file, every face has three or more corners that all exist, and the file is not laid out with a line
// for each vertex and face, so that damage is not taken for such a file.
//
// `line` is where reading by lines failed, for the warning (read_by_words). O(bytes); nothing is kept before all is
// right.
std::optional<MeshFile> read_off_words(std::string_view bytes, std::uint64_t line);

}  // namespace ryosen
