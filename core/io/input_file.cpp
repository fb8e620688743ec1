#include "core/io/input_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>
#include <new>
#include <string>
#include <system_error>
#include <utility>

namespace ryosen {
namespace {

Failure failure(const std::filesystem::path& path, int error) {
  const std::string name = path.string();
  Failure out{ExitCode::input_missing, {}};
  if (error == ENOENT || error == ENOTDIR) {
    out.message.code = "input_missing";
    out.message.text = {"There is no file " + name + ".", "ファイル " + name + " がありません。"};
  } else if (error == EISDIR) {
    out.message.code = "input_is_folder";
    out.message.text = {name + " is a folder, not a file.", name + " はファイルではなくフォルダーです。"};
  } else {
    const std::string reason = std::generic_category().message(error);
    out.message.code = "input_unreadable";
    out.message.text = {"Cannot read " + name + ": " + reason + ".", name + " を読めません: " + reason + "。"};
  }
  return out;
}

// Reads to the end into a buffer that grows when the size told is not the true one. Returns 0 or an error number.
int read_to_end(int descriptor, std::size_t expected, std::size_t limit, FileBytes& out) {
  std::size_t capacity = expected + 1;  // the byte more lets the end show without growing
  out.data.reset(new (std::nothrow) char[capacity]);
  if (!out.data) return ENOMEM;
  constexpr std::size_t most = std::size_t{1} << 30;
  while (true) {
    if (out.size > limit) return EFBIG;
    if (out.size == capacity) {
      std::unique_ptr<char[]> larger(new (std::nothrow) char[2 * capacity]);
      if (!larger) return ENOMEM;
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

}  // namespace

Result<FileBytes> read_whole_file(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY);
  if (descriptor < 0) return failure(path, errno);
  struct stat status;
  FileBytes out;
  int error = ::fstat(descriptor, &status) == 0 ? 0 : errno;
  if (error == 0 && S_ISDIR(status.st_mode)) error = EISDIR;
  // A pipe or device does not tell its size and may never end.
  constexpr std::size_t unknown_size = 1 << 16, most_unknown = 1 << 30;
  const bool is_regular = error == 0 && S_ISREG(status.st_mode);
  const std::size_t expected = is_regular ? static_cast<std::size_t>(status.st_size) : unknown_size;
  const std::size_t limit = is_regular ? std::numeric_limits<std::size_t>::max() : most_unknown;
  if (error == 0) error = read_to_end(descriptor, expected, limit, out);
  ::close(descriptor);
  if (error != 0) return failure(path, error);
  return out;
}

}  // namespace ryosen
