// Reading of the data section of a PLY file.
#pragma once

#include <optional>
#include <string_view>

#include "ryosen/base/result.h"
#include "ryosen/io/ply_builder.h"
#include "ryosen/io/ply_header.h"

namespace ryosen {

// Pass all values of `bytes` (the whole file) to the builder, as described by the header; return the failure, if any.
std::optional<Failure> read_ply_text(std::string_view bytes, const PlyHeader& header, PlyBuilder& builder);
std::optional<Failure> read_ply_binary(std::string_view bytes, const PlyHeader& header, PlyBuilder& builder);

// Passes the numbers of an ascii file to the builder as they come, whatever lines they stand on. Returns whether the
// file has exactly as many as its header announces, and every face three or more corners that all exist; where it has
// not, the builder must not be used any more.
bool read_ply_words(std::string_view bytes, const PlyHeader& header, PlyBuilder& builder);

// The failure for a count too large for the file's size.
Failure ply_count_too_large(const PlyHeader& header, std::size_t table);
// The failure for a file that ends after `there` rows of a table.
Failure ply_early_end(const PropertyTable& table, std::size_t there, FilePlace place);
// Whether a count is implausible: the file has room for fewer than a quarter of the rows.
bool is_absurd(std::size_t rows, std::size_t least_bytes_each, std::size_t bytes_left);

}  // namespace ryosen
