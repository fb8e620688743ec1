// What a file was like when it was read or written, to tell later whether somebody else has changed it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

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

  friend bool operator==(const FileState&, const FileState&) = default;

 private:
  struct Seen {
    std::int64_t bytes, seconds, nanoseconds;
    friend bool operator==(const Seen&, const Seen&) = default;
  };
  static std::optional<Seen> look(const std::filesystem::path& path);

  std::optional<Seen> seen_;
};

}  // namespace ryosen
