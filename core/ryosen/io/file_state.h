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
  // State of a file now. Pipes, devices and what cannot be looked at are no file. One system call.
  static FileState of(const std::filesystem::path& path);
  // Adds a hash of the content, unless it is known or the file has changed since. O(bytes).
  void learn_content(const std::filesystem::path& path);
  // A state that no file is in: every file has changed since, and one that is not there is gone.
  static FileState of_none_that_is();

  // Compares the content where its length is the same and anything else differs, so that a copy of the same bytes is no
  // change. Without a known content the length and the time of the last change decide. One system call, O(bytes) to
  // compare the content.
  Change since(const std::filesystem::path& path) const;
  // As since(), to be asked again and again: reads a file once for each change of its times.
  Change follow(const std::filesystem::path& path);
  // Whether it is of a file.
  bool is_known() const { return seen_.has_value(); }

  // "BYTES SECONDS NANOSECONDS [HASH]", to be read by another process; empty for no file.
  std::string text() const;
  // Inverse of text(); of no file where the numbers are something else, without a content where the hash is.
  static FileState from_text(std::string_view text);

 private:
  // Number and time of the last change of its status, which no program can set.
  struct Status {
    std::int64_t number, seconds, nanoseconds;
    friend bool operator==(const Status&, const Status&) = default;
  };
  struct Seen {
    std::int64_t bytes, seconds, nanoseconds;  // length, time of the last change of the content as programs set it
    std::optional<Status> status;              // none where it comes from a text
    friend bool operator==(const Seen&, const Seen&) = default;
  };
  static std::optional<Seen> look(const std::filesystem::path& path);
  Change change_to(const std::optional<Seen>& now, const std::filesystem::path& path) const;

  std::optional<Seen> seen_;
  std::optional<std::uint64_t> content_;  // content_hash()
  std::optional<Seen> other_;             // last state that follow() found to have another content
};

// A 64-bit hash of the content of a regular file, to tell whether it is the same again. None where it cannot be read.
// O(bytes), a piece of it in memory at a time.
std::optional<std::uint64_t> content_hash(const std::filesystem::path& path);

}  // namespace ryosen
