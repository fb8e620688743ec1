// The temporary file that a save writes beside its target.
#pragma once

#include <filesystem>
#include <optional>

#include "ryosen/io/descriptor.h"
#include "ryosen/io/unfinished_files.h"

namespace ryosen {

// Named `.NAME.ryosen-PROCESS.N`, locked (flock) for its life, and removed unless renamed. Failures leave errno set.
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

// Deletes what saves of this target left when they were killed: files of that pattern which no living process has
// locked.
void clear_leftovers(const std::filesystem::path& target);

}  // namespace ryosen
