#include "app/editor/recovery/owned_script.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "ryosen/io/folder_entries.h"
#include "ryosen/io/safe_write.h"

namespace ryosen {

namespace {

// Locks the file and checks that it still has that name; if not, returns false with errno 0.
bool own(int descriptor, const std::filesystem::path& path) {
  struct stat locked, named;
  errno = 0;
  return ::flock(descriptor, LOCK_EX | LOCK_NB) == 0 && ::fstat(descriptor, &locked) == 0 && S_ISREG(locked.st_mode) &&
         ::lstat(path.c_str(), &named) == 0 && locked.st_dev == named.st_dev && locked.st_ino == named.st_ino;
}

}  // namespace

Result<OwnedScript> OwnedScript::create(const std::filesystem::path& folder) {
  std::error_code error;
  if (std::filesystem::create_directories(folder, error)) {
    std::filesystem::permissions(folder, std::filesystem::perms::owner_all, error);
  }
  if (error) return not_writable(folder, error.value());
  constexpr int most_tries = 1000;
  const std::string stem = std::string(script_prefix) + std::to_string(::getpid());
  std::filesystem::path path;
  for (int i = 1; i <= most_tries; ++i) {
    path = folder / (stem + (i == 1 ? "" : "-" + std::to_string(i)) + std::string(script_suffix));
    const int descriptor = ::open(path.c_str(), O_RDWR | O_APPEND | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (descriptor >= 0) {
      // Another process scanning for lost scripts may have locked it first and deleted it as empty.
      if (own(descriptor, path)) return OwnedScript(std::move(path), descriptor);
      const int reason = errno;
      const bool is_contended = reason == EWOULDBLOCK || reason == ENOENT || reason == 0;
      ::close(descriptor);
      if (!is_contended) {
        ::unlink(path.c_str());
        return not_writable(path, reason);
      }
    } else if (errno != EEXIST) {
      return not_writable(path, errno);
    }
  }
  return not_writable(path, EEXIST);
}

std::optional<OwnedScript> OwnedScript::take(const std::filesystem::path& path) {
  struct stat named;
  // A pipe or device is not even opened.
  if (::lstat(path.c_str(), &named) != 0 || !S_ISREG(named.st_mode)) return std::nullopt;
  const int descriptor = ::open(path.c_str(), O_RDWR | O_APPEND | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (descriptor < 0) return std::nullopt;
  if (own(descriptor, path)) return OwnedScript(path, descriptor);
  ::close(descriptor);
  return std::nullopt;
}

OwnedScript::OwnedScript(OwnedScript&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

OwnedScript& OwnedScript::operator=(OwnedScript&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

OwnedScript::~OwnedScript() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::filesystem::path OwnedScript::companion(const std::string& extension) const {
  std::filesystem::path path = path_;
  return path.replace_extension(".original" + extension);
}

std::optional<std::string> OwnedScript::content() const {
  std::string text;
  char piece[1 << 14];
  for (;;) {
    const ssize_t count = ::pread(descriptor_, piece, sizeof piece, static_cast<off_t>(text.size()));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return std::nullopt;
    if (count == 0) return text;
    text.append(piece, static_cast<std::size_t>(count));
  }
}

void OwnedScript::cut(std::size_t size) {
  // If truncation fails, at least terminate the incomplete last line, which then does not parse.
  if (::ftruncate(descriptor_, static_cast<off_t>(size)) != 0) append("\n");
}

bool OwnedScript::append(std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(descriptor_, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

void OwnedScript::remove() {
  std::error_code ignored;
  const std::string stem = path_.stem().string() + ".original";
  for (const ListedEntry& entry : folder_entries(path_.parent_path(), ignored))
    if (entry.is_file && entry.path.filename().string().starts_with(stem)) std::filesystem::remove(entry.path, ignored);
  std::filesystem::remove(path_, ignored);
}

}  // namespace ryosen
