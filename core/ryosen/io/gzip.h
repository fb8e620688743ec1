// gzip files: their names, unpacking and packing.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "ryosen/base/result.h"
#include "ryosen/io/input_file.h"

namespace ryosen {

inline constexpr std::uint64_t most_unpacked_bytes = std::uint64_t{4} << 30;

// Whether the bytes start with the gzip magic.
bool is_gzip(std::string_view bytes);

// Whether a name ends in .gz (case-insensitive), and the name without it: x.obj for x.obj.gz, else the name itself.
bool has_gzip_name(const std::filesystem::path& path);
std::filesystem::path without_gzip(const std::filesystem::path& path);

// The concatenated content of all members. Fails, with the byte offset in the packed file, if it is damaged
// (gzip_damaged), truncated (gzip_cut), followed by other data (gzip_extra_data) or larger than `most` bytes unpacked
// (gzip_too_large). Unpacks twice, first only to count, so that a failure costs no memory. O(unpacked).
Result<FileBytes> unpack_gzip(std::string_view packed, std::uint64_t most = most_unpacked_bytes);

// The first unpacked bytes, as far as available; `packed` may be truncated anywhere.
std::string unpacked_head(std::string_view packed, std::size_t most);

// Deterministic: stores neither time nor name.
std::string pack_gzip(std::string_view bytes);

}  // namespace ryosen
