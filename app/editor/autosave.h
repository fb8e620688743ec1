// Keeps a script of what a session does in a folder of the user's while anything is unsaved, so that it can be brought
// back after the program has crashed (see recovery.h). Not after a crash of the machine: the lines are handed to the
// system, not brought to the disk.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/editor/owned_script.h"
#include "app/editor/recovery.h"

namespace ryosen {

// A session tells it what is done. An edit costs one short write. Whatever fails here, the edit stays done: the user is
// told once, and then nothing more is kept of this document.
class Autosave {
 public:
  // Nothing is written to the folder before the first edit; an empty path fails then.
  explicit Autosave(std::filesystem::path folder) : folder_(std::move(folder)) {}

  // Another document, just opened: what was kept of the one before is taken away. O(mesh).
  void begin(const Document& document);
  // One that a recovery has brought as far as it could, in a script of its own beside the one that is lost.
  void begin(const Document& document, SessionStart start);
  // One that a recovery has brought back whole, in the script that was lost.
  void go_on(OwnedScript script, const Document& document, SessionStart start);

  // A line has been done and is the last of the log. A sentence where, from now on, nothing can be brought back.
  std::optional<Text> note(const Session& session, const std::string& line);
  // A file is about to be written. Where the session began with that file, its content is kept first, because the edits
  // name the elements of it.
  std::optional<Text> before_save(const Session& session, const std::filesystem::path& target);

  // The session ends as its user wants it to, and nothing is left. Without this the script stays, to be recovered.
  void finish();

  const std::optional<OwnedScript>& script() const { return script_; }

 private:
  std::optional<Text> open_script(const Session& session);
  std::optional<Text> append(const std::string& text);
  std::optional<Text> keep_original(const std::filesystem::path& file);
  std::optional<Text> give_up(const Text& reason);
  std::string saved_remark() const;

  std::filesystem::path folder_;
  std::optional<OwnedScript> script_;
  SessionStart start_;
  std::filesystem::path file_;  // the document's, absolute
  bool has_failed_ = false;     // with this document
  bool has_warned_ = false;
};

}  // namespace ryosen
