// Which file a name leads to, through links and through the descriptors that the program was handed.
#pragma once

#include <sys/stat.h>

#include <filesystem>
#include <optional>
#include <utility>

namespace ryosen {

struct FileTarget {
  enum class Kind { nothing, file, folder, stream };  // stream: a pipe, a device or a socket
  using Number = std::pair<dev_t, ino_t>;             // what the system tells files apart by

  std::filesystem::path path;     // behind all links; there may be nothing there
  std::optional<int> descriptor;  // one of those that the program was handed (/dev/stdout, /dev/fd/N), which is meant
  Kind kind = Kind::nothing;
  std::optional<Number> number;  // of what is there
  std::optional<Number> folder;  // of the folder that it lies or would lie in; none for a descriptor
  struct stat status {};         // of what is there
  int error = 0;                 // why nothing could be found out, an error number
};

FileTarget target_of(const std::filesystem::path& path);

// Whether what is written there goes on to a reader, a device or a descriptor, and is no file to come back to.
bool is_stream(const std::filesystem::path& path);

// Whether both are one file, or would be where there is none yet.
bool is_same_file(const FileTarget& a, const FileTarget& b);

}  // namespace ryosen
