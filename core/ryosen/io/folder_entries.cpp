#include "ryosen/io/folder_entries.h"

#include <dirent.h>
#include <sys/stat.h>

#include <cerrno>
#include <memory>
#include <new>
#include <string_view>

namespace ryosen {

namespace {

ListedEntry listed_entry(std::filesystem::path path, const dirent& entry) {
  ListedEntry listed{std::move(path)};
  unsigned char type = entry.d_type;
  struct stat status;
  if (type == DT_UNKNOWN && ::lstat(listed.path.c_str(), &status) == 0) type = IFTODT(status.st_mode);
  listed.is_link = type == DT_LNK;
  listed.is_file = type == DT_REG;
  listed.is_folder =
      type == DT_DIR || (listed.is_link && ::stat(listed.path.c_str(), &status) == 0 && S_ISDIR(status.st_mode));
  return listed;
}

}  // namespace

std::vector<ListedEntry> folder_entries(const std::filesystem::path& folder, std::error_code& error) {
  std::vector<ListedEntry> entries;
  error.clear();
  const std::unique_ptr<DIR, int (*)(DIR*)> opened(::opendir(folder.c_str()), &::closedir);
  if (opened) errno = 0;
  while (const dirent* const entry = opened ? ::readdir(opened.get()) : nullptr) {
    const std::string_view name = entry->d_name;
    if (name != "." && name != "..") entries.push_back(listed_entry(folder / name, *entry));
    errno = 0;
  }
  if (errno == ENOMEM) throw std::bad_alloc();
  if (errno != 0) error.assign(errno, std::generic_category());
  return entries;
}

}  // namespace ryosen
