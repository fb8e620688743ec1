#include "ryosen/io/temporary_file.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>

#include "ryosen/base/uninterrupted.h"

namespace ryosen {
namespace {

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
    return !word.empty() && std::all_of(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; });
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

}  // namespace

void clear_leftovers(const std::filesystem::path& target) {
  const std::string folder = target.has_parent_path() ? target.parent_path().string() : ".";
  const std::string stem = stem_beside(target);
  const std::unique_ptr<DIR, int (*)(DIR*)> entries(::opendir(folder.c_str()), ::closedir);
  if (!entries) return;  // it may not be readable
  while (const dirent* const entry = ::readdir(entries.get()))
    if (is_name_beside(entry->d_name, stem)) remove_if_left(folder + "/" + entry->d_name);
}

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

}  // namespace ryosen
