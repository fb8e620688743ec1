#include "ryosen/io/safe_write.h"

#include <dirent.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ryosen/base/uninterrupted.h"
#include "ryosen/io/descriptor.h"
#include "ryosen/io/file_target.h"
#include "ryosen/io/numbers.h"
#include "ryosen/io/system_reason.h"

namespace ryosen {
namespace {

std::array<std::atomic<const char*>, 8> unfinished_paths{};
std::atomic<bool> is_file_in_place = false;
std::atomic<bool> is_stream_begun = false;

// Lists a file for its life. To be made and destroyed within a section (Uninterrupted) of files; `path` is to stay
// valid. Beyond eight at a time a file is not listed.
class UnfinishedFile {
 public:
  explicit UnfinishedFile(const char* path) noexcept {
    for (; place_ < unfinished_paths.size(); ++place_) {
      const char* none = nullptr;
      if (unfinished_paths[place_].compare_exchange_strong(none, path)) return;
    }
  }
  ~UnfinishedFile() {
    if (place_ < unfinished_paths.size()) unfinished_paths[place_] = nullptr;
  }
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;

 private:
  std::size_t place_ = 0;
};

void note_what_is_written() {
  is_file_in_place = true;
  is_stream_begun = false;
}

using Section = Uninterrupted::Section;

// What the names of all temporary files of this target begin with; no file of a person's own does by chance.
std::string stem_beside(const std::filesystem::path& target) {
  constexpr std::size_t most = 200;  // file systems allow 255
  return "." + target.filename().string().substr(0, most) + ".ryosen-";
}

// Whether it goes on as PROCESS.N.
bool is_name_beside(std::string_view name, std::string_view stem) {
  if (!name.starts_with(stem)) return false;
  name.remove_prefix(stem.size());
  const auto is_number = [](std::string_view word) {
    return !word.empty() && std::all_of(word.begin(), word.end(), is_digit);
  };
  const std::size_t point = std::min(name.find('.'), name.size() - 1);
  return is_number(name.substr(0, point)) && is_number(name.substr(point + 1));
}

// Deletes it where nobody has it locked. Whoever makes one sees afterwards whether it was deleted before it was locked.
void remove_if_left(const std::string& path) {
  const Descriptor file(
      retried([&] { return ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK | O_NOCTTY); }));
  struct stat opened, named;
  if (!file.is_open() || ::flock(file.number(), LOCK_EX | LOCK_NB) != 0) return;
  const bool is_same = ::fstat(file.number(), &opened) == 0 && ::lstat(path.c_str(), &named) == 0 &&
                       opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
  if (is_same && S_ISREG(opened.st_mode)) ::unlink(path.c_str());
}

// Deletes what saves of this target left when they were killed: files of that pattern which no living process has
// locked.
void clear_leftovers(const std::filesystem::path& target) {
  const std::string folder = target.has_parent_path() ? target.parent_path().string() : ".";
  const std::string stem = stem_beside(target);
  const std::unique_ptr<DIR, int (*)(DIR*)> entries(::opendir(folder.c_str()), ::closedir);
  if (!entries) return;  // it may not be readable
  while (const dirent* const entry = ::readdir(entries.get()))
    if (is_name_beside(entry->d_name, stem)) remove_if_left(folder + "/" + entry->d_name);
}

// The temporary file that a save writes beside its target: named `.NAME.ryosen-PROCESS.N`, locked (flock) for its life,
// and removed unless renamed. Failures leave errno set.
class TemporaryFile {
 public:
  // Makes it with default permissions under the first free name; not there where none can be made.
  explicit TemporaryFile(const std::filesystem::path& target);
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile();

  bool exists() const { return listed_.has_value(); }
  int descriptor() const { return file_.number(); }
  // Closes it and gives it the target's name.
  bool rename_to(const std::filesystem::path& target);

 private:
  // Makes one of this name; false where it is taken (EEXIST) or cannot be made.
  bool open();

  std::filesystem::path name_;
  Descriptor lock_;  // keeps the lock when `file_` is closed
  Descriptor file_;
  std::optional<UnfinishedFile> listed_;  // while it is there
};

TemporaryFile::TemporaryFile(const std::filesystem::path& target) {
  constexpr int most_tries = 1000;
  const std::string stem = stem_beside(target) + std::to_string(::getpid()) + ".";
  for (int i = 0; i < most_tries; ++i) {
    name_ = target.parent_path() / (stem + std::to_string(i));
    if (open() || errno != EEXIST) return;
  }
}

bool TemporaryFile::open() {
  const Uninterrupted section(Section::file);
  file_ = Descriptor(retried([&] { return ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666); }));
  if (!file_.is_open()) return false;
  // Where the file system knows no locks, nobody can take it for a leftover either.
  const bool is_locked = ::flock(file_.number(), LOCK_EX | LOCK_NB) == 0;
  struct stat status;
  if ((!is_locked && errno == EWOULDBLOCK) ||
      (is_locked && ::fstat(file_.number(), &status) == 0 && status.st_nlink == 0)) {
    file_.close();  // it was taken for a leftover before it was locked
    errno = EEXIST;
    return false;
  }
  if (is_locked) lock_ = Descriptor(::fcntl(file_.number(), F_DUPFD_CLOEXEC, 0));
  listed_.emplace(name_.c_str());
  return true;
}

TemporaryFile::~TemporaryFile() {
  if (!listed_) return;
  const int error = errno;
  const Uninterrupted section(Section::file);
  ::unlink(name_.c_str());
  listed_.reset();
  errno = error;
}

bool TemporaryFile::rename_to(const std::filesystem::path& target) {
  if (!file_.close()) return false;
  const Uninterrupted section(Section::file);
  if (retried([&] { return std::rename(name_.c_str(), target.c_str()); }) != 0) return false;
  listed_.reset();
  note_what_is_written();
  return true;
}

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
  if (out.is_open()) is_stream_begun = true;
  if (!out.is_open() || (is_pipe && ::fcntl(out.number(), F_SETFL, 0) != 0) || !write_all(out.number(), bytes) ||
      !out.close())
    return not_writable(path, errno);
  note_what_is_written();
  return success();
}

// Gives the new file the permissions and, if possible, the owner of the old one.
bool take_over_rights(int descriptor, const struct stat& old) {
  struct stat now;
  if (::fstat(descriptor, &now) == 0 && (now.st_uid != old.st_uid || now.st_gid != old.st_gid) &&
      ::fchown(descriptor, old.st_uid, old.st_gid) != 0 && errno != EPERM)
    return false;
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
      !write_all(beside.descriptor(), bytes) || !synchronise(beside.descriptor()) || !beside.rename_to(target))
    return failed();
  if (!folder.is_open())
    ::sync();
  else if (!synchronise(folder.number()))
    return not_durable(path, errno);
  return success();
}

}  // namespace

void remove_unfinished_files() noexcept {
  for (const auto& listed : unfinished_paths)
    if (const char* const path = listed) ::unlink(path);
}

bool is_stream_unfinished() noexcept { return is_stream_begun; }
bool is_something_written() noexcept { return is_file_in_place; }
void forget_what_is_written() noexcept { is_file_in_place = false; }

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
