// gzip files: their names, unpacking and packing.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/io/input_file.h"

namespace ryosen {

inline constexpr std::uint64_t most_unpacked_bytes = std::uint64_t{4} << 30;

// Whether the bytes start with the gzip magic.
bool is_gzip(std::string_view bytes);

// Whether a name ends in .gz, in any case, and the name of what is packed there: x.obj of x.obj.gz, else itself.
bool has_gzip_name(const std::filesystem::path& path);
std::filesystem::path without_gzip(const std::filesystem::path& path);

// What is packed in all members of such a file, one after another. Refuses, with the byte of the packed file, one that
// is damaged (gzip_damaged), ends early (gzip_cut), goes on with something else (gzip_extra_data) or holds more than
// `most` bytes (gzip_too_large). Unpacks twice, first only to count, so that a refusal costs no memory. O(unpacked).
Result<FileBytes> unpack_gzip(std::string_view packed, std::uint64_t most = most_unpacked_bytes);

// The first bytes of what is packed there, as many as can be had of `packed`, which may be cut anywhere.
std::string unpacked_head(std::string_view packed, std::size_t most);

// Deterministic: stores neither time nor name.
std::string pack_gzip(std::string_view bytes);

}  // namespace ryosen
