// What the window keeps for the user from one time to the next, in the folder of configuration: preferences and keys,
// the layout of the panels, and the files that were open. Plain text, a line each, which a person can read and change.
// Only the window reads them by itself, so that scripts and pictures come out the same for everybody.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ryosen/base/result.h"

namespace ryosen {

class Session;
struct Preferences;

// Reads preferences and sets all of them, or none where a line is broken: then the failure names file and line. A file
// that is not there has none. Lines about nothing that is known are returned: they are another version's.
struct ReadPreferences {
  std::map<std::string, std::string, std::less<>> values;
  std::vector<std::string> unknown;
  Text warning;  // about these; empty where there are none
};
Result<ReadPreferences> read_preferences(Session& session, const std::filesystem::path& file);

class UserFiles {
 public:
  static constexpr std::size_t most_recent = 10;

  // Without a folder nothing is read or kept. `preferences` is another file in place of the folder's own.
  explicit UserFiles(std::filesystem::path folder, std::filesystem::path preferences = {});

  // Sets what was kept. A sentence for each file that is broken: what it holds is then as at first, and it is put aside
  // as NAME.broken before it is written again.
  Text begin(Session& session);
  // What is so from here on is nothing that the user chose in the window, such as a flag of the command line.
  void take_as_given(const Session& session);
  // Writes what has changed since. A sentence, once, where that is not possible.
  std::optional<Text> keep(Session& session);

 private:
  struct Kept {
    std::filesystem::path path;
    std::string written;     // its content
    bool is_broken = false;  // it is not what it should be, and stays until it is put aside
  };
  void begin_layout(Session& session, Text& said);
  void begin_recent(Preferences& preferences);
  void note_recent(const std::filesystem::path& file, Preferences& preferences);
  Status write(Kept& kept, const std::string& content);
  std::string preferences_now(const Session& session);

  std::filesystem::path folder_;
  Kept preferences_, layout_, recent_;
  std::vector<std::string> unknown_;                       // lines of preferences that stay
  std::map<std::string, std::string, std::less<>> given_;  // values that were not chosen in the window
  std::map<std::string, std::string, std::less<>> file_;   // what the file has
  std::string last_file_;                                  // that was noted as recent
  bool has_failed_ = false;
};

}  // namespace ryosen
