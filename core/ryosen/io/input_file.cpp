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
  const auto fail = [](Code code, Text text) { return make_failure(ExitCode::input_missing, code, std::move(text)); };
  if (name.empty()) return fail("input_missing", empty_name());
  if (error == ENOENT || error == ENOTDIR)
    return fail("input_missing", {"There is no file " + name + ".", "ファイル " + name + " がありません。"});
  if (error == EISDIR)
    return fail("input_is_folder", {name + " is a folder, not a file.", name + " はファイルではなくフォルダです。"});
  if (error == not_a_file)
    return fail("input_not_a_file", {name + " is a pipe, device or socket, not a file.",
                                     name + " は通常のファイルではありません（パイプ、デバイス、ソケットなど）。"});
  const Text reason = system_reason(error);
  return fail("input_unreadable",
              {"Cannot read " + name + ": " + reason.en + ".", name + " を読めません：" + reason.ja + "。"});
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
    const std::size_t room = std::min(capacity - out.size, most);
    const ssize_t count = retried([&] { return ::read(descriptor, out.data.get() + out.size, room); });
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

// Opens without blocking, and gets the file type or an error.
Descriptor open_input(const std::filesystem::path& path, struct stat& status, int& error) {
  Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK));
  if (!file.is_open())
    error = errno == ENXIO ? not_a_file : errno;  // a socket, or a device without a driver
  else if (::fstat(file.number(), &status) != 0)
    error = errno;
  else if (S_ISDIR(status.st_mode))
    error = EISDIR;
  else if (is_handed_over(path) && (S_ISFIFO(status.st_mode) || ends_like_a_pipe(file.number(), status)))
    error = ::fcntl(file.number(), F_SETFL, 0) == 0 ? 0 : errno;  // back to blocking reads: the writer may be slower
  else if (!S_ISREG(status.st_mode))
    error = not_a_file;
  return file;
}

}  // namespace

Result<FileBytes> read_whole_file(const std::filesystem::path& path) {
  struct stat status;
  int error = 0;
  const Descriptor file = open_input(path, status, error);
  if (error != 0) return failure(path, error);
  // A pipe has no known size and may never end.
  constexpr std::size_t unknown_size = 1 << 16, most_unknown = 1 << 30;
  const bool is_regular = S_ISREG(status.st_mode);
  const std::size_t expected = is_regular ? static_cast<std::size_t>(status.st_size) : unknown_size;
  const std::size_t limit = is_regular ? std::numeric_limits<std::size_t>::max() : most_unknown;
  FileBytes out;
  error = read_to_end(file.number(), expected, limit, out);
  if (error != 0) return failure(path, error);
  return out;
}

}  // namespace ryosen
