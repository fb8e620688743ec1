#include "ryosen/io/input_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>
#include <new>
#include <string>
#include <utility>

#include "ryosen/base/column_memory.h"
#include "ryosen/io/descriptor.h"
#include "ryosen/io/system_reason.h"

namespace ryosen {
namespace {

constexpr int not_a_file = -1;  // not an errno value

Failure failure(const std::filesystem::path& path, int error) {
  if (error == ENOMEM) throw std::bad_alloc();
  const std::string name = path.string();
  Failure out{ExitCode::input_missing, {}};
  if (name.empty()) {
    out.message.code = "input_missing";
    out.message.text = empty_name();
  } else if (error == ENOENT || error == ENOTDIR) {
    out.message.code = "input_missing";
    out.message.text = {"There is no file " + name + ".", "ファイル " + name + " がありません。"};
  } else if (error == EISDIR) {
    out.message.code = "input_is_folder";
    out.message.text = {name + " is a folder, not a file.", name + " はファイルではなくフォルダです。"};
  } else if (error == not_a_file) {
    out.message.code = "input_not_a_file";
    out.message.text = {name + " is a pipe, device or socket, not a file.",
                        name + " は通常のファイルではありません（パイプ、デバイス、ソケットなど）。"};
  } else {
    const Text reason = system_reason(error);
    out.message.code = "input_unreadable";
    out.message.text = {"Cannot read " + name + ": " + reason.en + ".", name + " を読めません：" + reason.ja + "。"};
  }
  return out;
}

// Reads to the end into a buffer that grows if the expected size is wrong. Returns 0 or an error number.
int read_to_end(int descriptor, std::size_t expected, std::size_t limit, FileBytes& out) {
  std::size_t capacity = expected + 1;  // one extra byte detects the end without growing
  out.data.reset(new char[capacity]);
  offer_huge_pages(out.data.get(), capacity);
  touch_pages(out.data.get(), capacity);
  constexpr std::size_t most = std::size_t{1} << 30;
  while (true) {
    if (out.size > limit) return EFBIG;
    if (out.size == capacity) {
      std::unique_ptr<char[]> larger(new char[2 * capacity]);
      std::memcpy(larger.get(), out.data.get(), out.size);
      out.data = std::move(larger);
      capacity *= 2;
    }
    const ssize_t count = ::read(descriptor, out.data.get() + out.size, std::min(capacity - out.size, most));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno;
    if (count == 0) return 0;
    out.size += static_cast<std::size_t>(count);
  }
}

// A descriptor inherited from the parent process: standard input, a shell's <(...).
bool is_handed_over(const std::filesystem::path& path) {
  const std::string& name = path.native();
  return name == "/dev/stdin" || name.starts_with("/dev/fd/") || name.starts_with("/proc/self/fd/");
}

// A device that ends: the null device, or a terminal at which somebody types.
bool ends_like_a_pipe(int descriptor, const struct stat& status) {
  struct stat null;
  if (!S_ISCHR(status.st_mode)) return false;
  return ::isatty(descriptor) == 1 || (::stat("/dev/null", &null) == 0 && null.st_rdev == status.st_rdev);
}

// Opens without blocking, and gets the file type. Returns the descriptor, or -1 with an error.
int open_input(const std::filesystem::path& path, struct stat& status, int& error) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK);
  if (descriptor < 0) {
    error = errno == ENXIO ? not_a_file : errno;  // a socket, or a device without a driver
    return -1;
  }
  if (::fstat(descriptor, &status) != 0)
    error = errno;
  else if (S_ISDIR(status.st_mode))
    error = EISDIR;
  else if (is_handed_over(path) && (S_ISFIFO(status.st_mode) || ends_like_a_pipe(descriptor, status)))
    error = ::fcntl(descriptor, F_SETFL, 0) == 0 ? 0 : errno;  // back to blocking reads: the writer may be slower
  else if (!S_ISREG(status.st_mode))
    error = not_a_file;
  if (error == 0) return descriptor;
  ::close(descriptor);
  return -1;
}

}  // namespace

Result<FileBytes> read_whole_file(const std::filesystem::path& path) {
  struct stat status;
  int error = 0;
  const int descriptor = open_input(path, status, error);
  if (descriptor < 0) return failure(path, error);
  // A pipe has no known size and may never end.
  constexpr std::size_t unknown_size = 1 << 16, most_unknown = 1 << 30;
  const bool is_regular = S_ISREG(status.st_mode);
  const std::size_t expected = is_regular ? static_cast<std::size_t>(status.st_size) : unknown_size;
  const std::size_t limit = is_regular ? std::numeric_limits<std::size_t>::max() : most_unknown;
  FileBytes out;
  const Descriptor owner(descriptor);
  error = read_to_end(descriptor, expected, limit, out);
  if (error != 0) return failure(path, error);
  return out;
}

}  // namespace ryosen
