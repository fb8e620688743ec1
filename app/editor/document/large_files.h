// Which files take long to read.
#pragma once

#include <cstdint>
#include <filesystem>

namespace ryosen {

// 0 where it is no plain file, or is not there.
std::uintmax_t bytes_of_plain_file(const std::filesystem::path& file);
// Whether reading a file takes so long that one wants to be told: of another kind than a plain file it is not known.
bool is_long_to_read(const std::filesystem::path& file);

}  // namespace ryosen
