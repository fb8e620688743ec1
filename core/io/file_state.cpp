#include "core/io/file_state.h"

#include <sys/stat.h>

namespace ryosen {

std::optional<FileState::Seen> FileState::look(const std::filesystem::path& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return Seen{status.st_size, status.st_mtim.tv_sec, status.st_mtim.tv_nsec};
}

FileState FileState::of(const std::filesystem::path& path) {
  FileState state;
  state.seen_ = look(path);
  return state;
}

FileState::Change FileState::since(const std::filesystem::path& path) const {
  if (!seen_) return Change::none;
  const std::optional<Seen> now = look(path);
  if (!now) return Change::gone;
  return *now == *seen_ ? Change::none : Change::changed;
}

}  // namespace ryosen
