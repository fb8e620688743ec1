// A file of lines that one process owns for as long as it lives.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/result.h"

namespace ryosen {

// Open and locked: no other can own the file meanwhile, in this process or another, and when the process ends, however it
// ends, nobody owns it. What is appended is handed to the system at once, but not brought to the disk: it outlives the
// program, not a power cut.
class OwnedScript {
 public:
  // Makes a new file in the folder, and the folder where it is missing; only the user may read them. The name tells the
  // process. Fails with output_not_writable.
  static Result<OwnedScript> create(const std::filesystem::path& folder);
  // Takes a file that is there; nothing where it is not, or where somebody owns it.
  static std::optional<OwnedScript> take(const std::filesystem::path& path);

  OwnedScript(OwnedScript&& other) noexcept;
  OwnedScript& operator=(OwnedScript&& other) noexcept;
  ~OwnedScript();  // gives the file up; it stays

  const std::filesystem::path& path() const { return path_; }
  // Where this process may put a file that goes with the script, with this extension (".obj").
  std::filesystem::path companion(const std::string& extension) const;
  // All of its bytes; what could be read of them.
  std::string content() const;
  // Ends the file after so many bytes.
  void cut(std::size_t size);
  // False, with errno set, where not all could be appended.
  bool append(std::string_view text);
  // Takes the file and its companions away.
  void remove();

 private:
  OwnedScript(std::filesystem::path path, int descriptor) : path_(std::move(path)), descriptor_(descriptor) {}

  std::filesystem::path path_;
  int descriptor_ = -1;
};

// The names of scripts begin and end so.
inline constexpr std::string_view script_prefix = "session-", script_suffix = ".ryosen";

}  // namespace ryosen
