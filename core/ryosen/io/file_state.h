// What a file was like when it was read or written, to tell later whether somebody else has changed it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace ryosen {

class FileState {
 public:
  enum class Change { none, changed, gone };

  // Of no file, which never changes.
  FileState() = default;
  // Of a file as it is now. Pipes, devices and what cannot be looked at are no file.
  static FileState of(const std::filesystem::path& path);

  // By length and time of the last change; a file that was only moved there is told as changed too. One system call.
  Change since(const std::filesystem::path& path) const;
  // A state that no file is in: every file has changed since, and one that is not there is gone.
  static FileState of_none_that_is();
  // Whether it is of a file.
  bool is_known() const { return seen_.has_value(); }

  // "BYTES SECONDS NANOSECONDS", to be read by another process; empty for no file.
  std::string text() const;
  // Inverse of text(); of no file where it is something else.
  static FileState from_text(std::string_view text);

  friend bool operator==(const FileState&, const FileState&) = default;

 private:
  struct Seen {
    std::int64_t bytes, seconds, nanoseconds;
    friend bool operator==(const Seen&, const Seen&) = default;
  };
  static std::optional<Seen> look(const std::filesystem::path& path);

  std::optional<Seen> seen_;
};

// A 64-bit hash of the content of a regular file, to tell whether it is the same again. None where it cannot be read.
// O(bytes), a piece of it in memory at a time.
std::optional<std::uint64_t> content_hash(const std::filesystem::path& path);

}  // namespace ryosen
