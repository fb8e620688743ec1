// What saves that are under way have begun to write, for whoever ends the program in the middle of one.
#pragma once

#include <cstddef>

namespace ryosen {

// Lists a file for its life. To be made and destroyed within a section (Uninterrupted) of files; `path` is to stay
// valid. Beyond eight at a time a file is not listed.
class UnfinishedFile {
 public:
  explicit UnfinishedFile(const char* path) noexcept;
  ~UnfinishedFile();
  UnfinishedFile(const UnfinishedFile&) = delete;
  UnfinishedFile& operator=(const UnfinishedFile&) = delete;

 private:
  std::size_t place_;
};

// Deletes those that are listed. May be called within a signal handler, while no section is under way.
void remove_unfinished_files() noexcept;

// Whether a pipe, a device or a descriptor that was handed over is being written, or was left in the middle.
bool is_stream_unfinished() noexcept;
void note_begun_stream() noexcept;  // note_what_is_written() ends it

// Whether a file has been written whole, and its name is in place, since the start or the last call of
// forget_what_is_written().
bool is_something_written() noexcept;
void note_what_is_written() noexcept;
void forget_what_is_written() noexcept;

}  // namespace ryosen
