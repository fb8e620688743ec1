#include "ryosen/io/folder_entries.h"

#include <dirent.h>

#include <cerrno>
#include <memory>
#include <new>
#include <string_view>

namespace ryosen {

std::vector<std::filesystem::directory_entry> folder_entries(const std::filesystem::path& folder,
                                                             std::error_code& error) {
  std::vector<std::filesystem::directory_entry> entries;
  error.clear();
  const std::unique_ptr<DIR, int (*)(DIR*)> listed(::opendir(folder.c_str()), &::closedir);
  errno = listed ? 0 : errno;
  while (const dirent* const entry = listed ? ::readdir(listed.get()) : nullptr) {
    std::error_code ignored;
    const std::string_view name = entry->d_name;
    if (name != "." && name != "..") entries.emplace_back(folder / name, ignored);
    errno = 0;
  }
  if (errno == ENOMEM) throw std::bad_alloc();
  if (errno != 0) error.assign(errno, std::generic_category());
  return entries;
}

}  // namespace ryosen
