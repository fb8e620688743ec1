// Reads on several threads what nearly all rows of a large ascii PLY look like.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "ryosen/io/ply_builder.h"

namespace ryosen {

// Where reading stopped.
struct PlainRows {
  std::size_t rows = 0, bytes = 0;
};

// Reads up to `most` rows of a table from the start of `text`, which begins behind row `first` - 1 and line `lines`, as
// long as each is one line of nothing but finite decimal numbers that the mesh takes, or of one list: a triangle. What
// is read is as if it had been read row by row; of a row that is not like that, and of tables with other properties,
// nothing is.
PlainRows read_plain_rows(std::string_view text, PropertyTable& table, std::span<const PlyTarget> targets,
                          std::size_t first, std::size_t most, std::uint64_t lines, PlyBuilder& builder);

}  // namespace ryosen
