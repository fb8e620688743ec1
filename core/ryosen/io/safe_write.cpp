#include "ryosen/io/safe_write.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <mutex>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "ryosen/io/descriptor.h"
#include "ryosen/io/file_target.h"
#include "ryosen/io/system_reason.h"
#include "ryosen/io/temporary_file.h"

namespace ryosen {
namespace {

constexpr Code not_durable_code = "output_not_durable";

Failure cannot_write(const std::filesystem::path& path, const Text& reason, Code code = "output_not_writable") {
  if (path.empty()) return make_failure(ExitCode::output_not_writable, code, empty_name());
  return make_failure(ExitCode::output_not_writable, code,
                      {"Cannot write " + path.string() + ": " + reason.en + ".",
                       path.string() + " に書き込めません：" + reason.ja + "。"});
}

Failure not_durable(const std::filesystem::path& path, int error) {
  const Text reason = system_reason(error);
  return make_failure(
      ExitCode::output_not_writable, not_durable_code,
      {path.string() + " is written, but it is not certain that it survives a power cut: " + reason.en + ".",
       path.string() + " は書き出しましたが、停電が起きても残るかどうかは確かではありません：" + reason.ja + "。"});
}

std::mutex names_in_place_mutex;
std::vector<std::string> names_in_place;

// Notes a written file; without memory for the note the file stays written.
void note_in_place(const std::filesystem::path& path) {
  try {
    const std::lock_guard lock(names_in_place_mutex);
    std::string name = path.string();
    if (std::find(names_in_place.begin(), names_in_place.end(), name) == names_in_place.end())
      names_in_place.push_back(std::move(name));
  } catch (const std::bad_alloc&) {
  }
}

// For a descriptor that whoever handed it over has set to wait for nobody.
bool wait_until_writable(int descriptor) {
  pollfd wanted{descriptor, POLLOUT, 0};
  return retried([&] { return ::poll(&wanted, 1, -1); }) > 0;
}

bool write_all(int descriptor, std::string_view bytes) {
  constexpr std::size_t most = std::size_t{1} << 30;
  while (!bytes.empty()) {
    const ssize_t written = retried([&] { return ::write(descriptor, bytes.data(), std::min(bytes.size(), most)); });
    if (written < 0 && errno == EAGAIN && wait_until_writable(descriptor)) continue;
    if (written < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

bool synchronise(int descriptor) {
  // Some file systems do not support it; that is not an error.
  return retried([&] { return ::fsync(descriptor); }) == 0 || errno == EINVAL || errno == ENOTSUP;
}

// For its life the reader of a pipe who goes away makes a write fail and does not end the program.
class PipeSignal {
 public:
  PipeSignal() : before_(std::signal(SIGPIPE, SIG_IGN)) {}
  PipeSignal(const PipeSignal&) = delete;
  PipeSignal& operator=(const PipeSignal&) = delete;
  ~PipeSignal() { std::signal(SIGPIPE, before_); }

 private:
  void (*before_)(int);
};

// Into what is there: a device, a pipe, or whatever a descriptor is of that the program was handed.
Status write_through(const std::filesystem::path& path, const FileTarget& target, std::string_view bytes) {
  // A pipe that nobody reads would keep whoever opens it waiting.
  const bool is_pipe = S_ISFIFO(target.status.st_mode) && !target.descriptor;
  const int flags = O_WRONLY | O_CLOEXEC | O_NOCTTY | (is_pipe ? O_NONBLOCK : 0);
  Descriptor out(retried([&] {
    return target.descriptor ? ::fcntl(*target.descriptor, F_DUPFD_CLOEXEC, 0) : ::open(target.path.c_str(), flags);
  }));
  if (!out.is_open() && is_pipe && errno == ENXIO)
    return cannot_write(path, {"nobody reads this pipe; start its reader first",
                               "パイプの読み手がいません（先に読み手を起動してください）"});
  const PipeSignal ignored;
  if (out.is_open()) note_begun_stream();
  if (!out.is_open() || (is_pipe && ::fcntl(out.number(), F_SETFL, 0) != 0) || !write_all(out.number(), bytes) ||
      !out.close()) {
    return not_writable(path, errno);
  }
  note_what_is_written();
  return success();
}

// Gives the new file the permissions and, if possible, the owner of the old one.
bool take_over_rights(int descriptor, const struct stat& old) {
  struct stat now;
  if (::fstat(descriptor, &now) == 0 && (now.st_uid != old.st_uid || now.st_gid != old.st_gid) &&
      ::fchown(descriptor, old.st_uid, old.st_gid) != 0 && errno != EPERM) {
    return false;
  }
  return retried([&] { return ::fchmod(descriptor, old.st_mode & 07777); }) == 0;
}

}  // namespace

Failure not_writable(const std::filesystem::path& path, int error) { return cannot_write(path, system_reason(error)); }

namespace {

Status write_in_place(const std::filesystem::path& path, std::string_view bytes) {
  const FileTarget found = target_of(path);
  const std::filesystem::path& target = found.path;
  const auto failed = [&] { return not_writable(path, errno); };
  if (found.error != 0) return not_writable(path, found.error);
  const bool replaces = found.kind != FileTarget::Kind::nothing;
  if (found.kind == FileTarget::Kind::folder) return cannot_write(path, system_reason(EISDIR), "output_is_folder");
  if (target.filename().empty()) return not_writable(path, ENOENT);
  if (found.kind == FileTarget::Kind::stream || found.descriptor) return write_through(path, found, bytes);
  if (replaces && ::faccessat(AT_FDCWD, target.c_str(), W_OK, AT_EACCESS) != 0) return failed();

  const std::filesystem::path parent = target.has_parent_path() ? target.parent_path() : ".";
  // Opened first, so that after the rename only the sync can fail. The folder may be write-only.
  const Descriptor folder(retried([&] { return ::open(parent.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); }));
  if (!folder.is_open() && errno != EACCES) return failed();
  clear_leftovers(target);
  TemporaryFile beside(parent / target.filename());
  if (!beside.exists() || (replaces && !take_over_rights(beside.descriptor(), found.status)) ||
      !write_all(beside.descriptor(), bytes) || !synchronise(beside.descriptor()) || !beside.rename_to(target)) {
    return failed();
  }
  if (!folder.is_open())
    ::sync();
  else if (!synchronise(folder.number()))
    return not_durable(path, errno);
  return success();
}

}  // namespace

Status safe_write(const std::filesystem::path& path, std::string_view bytes) {
  Status status = write_in_place(path, bytes);
  if (is_in_place(status)) note_in_place(path);
  return status;
}

std::vector<std::string> files_put_in_place() {
  const std::lock_guard lock(names_in_place_mutex);
  return names_in_place;
}

bool is_in_place(const Status& status) { return status.ok() || status.failure().message.code == not_durable_code; }

}  // namespace ryosen
