// Reads the data of a PLY file that follow its header.
#pragma once

#include <optional>
#include <string_view>

#include "core/base/result.h"
#include "core/io/ply_builder.h"
#include "core/io/ply_header.h"

namespace ryosen {

// Hand over all values of `bytes` (the whole file), which the header describes; the failure if there is one.
std::optional<Failure> read_ply_text(std::string_view bytes, const PlyHeader& header, PlyBuilder& builder);
std::optional<Failure> read_ply_binary(std::string_view bytes, const PlyHeader& header, PlyBuilder& builder);

// The failure of a count that a file of this size cannot hold.
Failure ply_count_too_large(const PropertyTable& table, std::uint64_t line);
// The failure of a file that ends after `there` rows of a table.
Failure ply_early_end(const PropertyTable& table, std::size_t there, FilePlace place);
// Whether the claim is out of all proportion to the file: there is room for fewer than a quarter of the rows.
bool is_absurd(std::size_t rows, std::size_t least_bytes_each, std::size_t bytes_left);

}  // namespace ryosen
