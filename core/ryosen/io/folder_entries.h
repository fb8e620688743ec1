// The entries of a folder, listed also where memory lacks.
#pragma once

#include <filesystem>
#include <system_error>
#include <vector>

namespace ryosen {

struct ListedEntry {
  std::filesystem::path path;
  bool is_link = false;
  bool is_file = false;    // a regular one, and no link
  bool is_folder = false;  // or a link to one
};

// The entries of a folder in no order, as far as it could be read before an error. Throws std::bad_alloc, where
// std::filesystem::directory_iterator ends the program.
std::vector<ListedEntry> folder_entries(const std::filesystem::path& folder, std::error_code& error);

}  // namespace ryosen
