// Crash recovery: writes a script of the session's edits to a per-user folder while anything is unsaved (see
// recovery.h). It survives a crash of the program, not of the machine: lines are written but not synced.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "app/editor/recovery/owned_script.h"
#include "app/editor/recovery/recovery.h"
#include "ryosen/document/document.h"

namespace ryosen {

// Called by the session. An edit costs one short write, the first one behind the opening of a file a copy of that file,
// and a save that the file is read once more. If writing fails, the edit itself stands: the user is told
// once, and recording stops for this document.
class Autosave {
 public:
  // Nothing is written before the first edit; with an empty path that write fails.
  explicit Autosave(std::filesystem::path folder) : folder_(std::move(folder)) {}

  // For a newly opened document; deletes the script of the previous one. O(mesh).
  void begin(const Document& document);
  // For a partially recovered document; uses a new script, the lost one is kept.
  void begin(const Document& document, SessionStart start);
  // The same at once, with what the session has done to it. Returns a message if that fails.
  std::optional<Text> begin_anew(const Document& document, const std::vector<std::string>& log, SessionStart start);
  // For a fully recovered document; continues the lost script.
  void go_on(OwnedScript script, const Document& document, const LostSession& lost);

  // After a line was executed, which ends the log now. Returns a message if recording has just failed.
  std::optional<Text> note(const Document& document, const std::vector<std::string>& log);
  // Before a file is written. If the session started from that file, there is a copy of it first, because the edits
  // refer to its elements.
  std::optional<Text> before_save(const Document& document, const std::vector<std::string>& log,
                                  const std::filesystem::path& target);

  // The document counts as saved or unsaved, or knows its file as another one, without a line that says so.
  void note_document(const Document& document);

  // No further edit of this document is recorded, for one found no memory; the next note says so.
  void stop() noexcept { has_failed_ = lacked_memory_ = true; }

  // Ends the session normally and deletes the script. Without this call it stays for recovery.
  void finish();

  const std::optional<OwnedScript>& script() const { return script_; }

 private:
  std::optional<Text> open_script(const Document& document, const std::vector<std::string>& log);
  std::optional<Text> append(const std::string& text);
  std::error_code copy_as_original(const std::filesystem::path& file);
  void write_original(const Document& document);
  std::optional<Text> keep_original(const std::filesystem::path& file);
  void keep_start(const Document& document);
  std::optional<Text> give_up(const Text& reason);
  std::string saved_remark() const;
  // What the script has to say of the document behind so many new lines; empty where these say it.
  std::string remark_behind(std::size_t lines, const Document& document);

  std::filesystem::path folder_;
  std::optional<OwnedScript> script_;
  SessionStart start_;
  std::filesystem::path file_;  // the document's, absolute
  Document::Unsaved unsaved_;   // as the script says it
  bool has_failed_ = false;     // for this document
  bool lacked_memory_ = false;  // and nobody has been told
  bool has_warned_ = false;
};

}  // namespace ryosen
