// An append-only text file that is locked by one process for its lifetime.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "ryosen/base/result.h"

namespace ryosen {

// Open and exclusively locked; the lock ends with the process, even on a crash. Appended text is written immediately
// but not synced: it survives a crash of the program, not a power failure.
class OwnedScript {
 public:
  // Creates a new file in the folder, and the folder if missing, readable only by the user. The name contains the
  // process id. Fails with output_not_writable.
  static Result<OwnedScript> create(const std::filesystem::path& folder);
  // Opens and locks an existing file; none if it does not exist, is locked, or is no regular file.
  static std::optional<OwnedScript> take(const std::filesystem::path& path);

  OwnedScript(OwnedScript&& other) noexcept;
  OwnedScript& operator=(OwnedScript&& other) noexcept;
  ~OwnedScript();  // releases the lock; the file stays

  const std::filesystem::path& path() const { return path_; }
  // A path for a companion file of the script with this extension (".obj").
  std::filesystem::path companion(const std::string& extension) const;
  // The content; none if it cannot be read.
  std::optional<std::string> content() const;
  // Truncates the file to `size` bytes.
  void cut(std::size_t size);
  // False, with errno set, if not all of it could be written.
  bool append(std::string_view text);
  // Deletes the file and its companions.
  void remove();

 private:
  OwnedScript(std::filesystem::path path, int descriptor) : path_(std::move(path)), descriptor_(descriptor) {}

  std::filesystem::path path_;
  int descriptor_ = -1;
};

// Prefix and suffix of script names.
inline constexpr std::string_view script_prefix = "session-", script_suffix = ".ryosen";

}  // namespace ryosen
