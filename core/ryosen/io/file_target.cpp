#include "ryosen/io/file_target.h"

#include <cerrno>
#include <charconv>
#include <string>
#include <string_view>
#include <system_error>

namespace ryosen {
namespace {

std::optional<int> handed_descriptor(const std::filesystem::path& path) {
  std::error_code ignored;
  const std::string name = std::filesystem::absolute(path, ignored).lexically_normal().string();
  constexpr std::string_view streams[] = {"/dev/stdin", "/dev/stdout", "/dev/stderr"};
  for (int i = 0; i < 3; ++i)
    if (name == streams[i]) return i;
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    if (!name.starts_with(folder)) continue;
    int number = -1;
    const char* const end = name.data() + name.size();
    const auto [stop, error] = std::from_chars(name.data() + folder.size(), end, number);
    if (error == std::errc() && stop == end && number >= 0) return number;
  }
  return std::nullopt;
}

// Goes through any chain of links, the last of which may point to nothing yet.
void follow_links(FileTarget& target) {
  constexpr int most_links = 40;
  for (int i = 0; i < most_links; ++i) {
    target.descriptor = handed_descriptor(target.path);
    std::error_code code;
    if (target.descriptor || !std::filesystem::is_symlink(std::filesystem::symlink_status(target.path, code))) return;
    const std::filesystem::path next = std::filesystem::read_symlink(target.path, code);
    if (code) {
      target.error = code.value();
      return;
    }
    target.path = next.is_absolute() ? next : target.path.parent_path() / next;
  }
  target.error = ELOOP;
}

FileTarget::Kind kind_of(mode_t mode) {
  return S_ISREG(mode) ? FileTarget::Kind::file : S_ISDIR(mode) ? FileTarget::Kind::folder : FileTarget::Kind::stream;
}

}  // namespace

FileTarget target_of(const std::filesystem::path& path) {
  FileTarget target;
  target.path = path;
  follow_links(target);
  if (target.error != 0) return target;
  const bool is_there = target.descriptor ? ::fstat(*target.descriptor, &target.status) == 0
                                          : ::stat(target.path.c_str(), &target.status) == 0;
  if (is_there) {
    target.kind = kind_of(target.status.st_mode);
    target.number = {target.status.st_dev, target.status.st_ino};
  } else if (target.descriptor || errno != ENOENT) {
    target.error = errno;
  }
  struct stat folder;
  const std::filesystem::path parent = target.path.has_parent_path() ? target.path.parent_path() : ".";
  if (!target.descriptor && ::stat(parent.c_str(), &folder) == 0) target.folder = {folder.st_dev, folder.st_ino};
  return target;
}

bool is_stream(const std::filesystem::path& path) {
  const FileTarget target = target_of(path);
  return target.kind == FileTarget::Kind::stream || target.descriptor;
}

bool is_same_file(const FileTarget& a, const FileTarget& b) {
  if (a.number && a.number == b.number) return true;
  return a.folder && a.folder == b.folder && a.path.filename() == b.path.filename();
}

}  // namespace ryosen
