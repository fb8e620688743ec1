// What is in a folder.
#pragma once

#include <filesystem>
#include <system_error>
#include <vector>

namespace ryosen {

// The entries of a folder in no order, as far as it could be read before an error. Throws std::bad_alloc, where
// std::filesystem::directory_iterator ends the program.
std::vector<std::filesystem::directory_entry> folder_entries(const std::filesystem::path& folder,
                                                             std::error_code& error);

}  // namespace ryosen
