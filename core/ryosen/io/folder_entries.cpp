#include "ryosen/io/folder_entries.h"

namespace ryosen {

std::vector<std::filesystem::directory_entry> folder_entries(const std::filesystem::path& folder,
                                                             std::error_code& error) {
  std::vector<std::filesystem::directory_entry> entries;
  error.clear();
  try {
    for (const std::filesystem::directory_entry& entry : std::filesystem::directory_iterator(folder))
      entries.push_back(entry);
  } catch (const std::filesystem::filesystem_error& fault) {
    error = fault.code();
  }
  return entries;
}

}  // namespace ryosen
