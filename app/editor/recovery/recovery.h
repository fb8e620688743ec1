// Recovery of unsaved edits after a crash. Scripts of edits are in a per-user folder (see autosave.h); one that no
// process has locked belongs to a crashed session.
//
// The script can be run by `ryosen edit --new --script` and contains remarks:
//   # ryosen session 1
//   # mesh 0123456789abcdef      the hash of the mesh before the first edit
//   open /home/me/in.obj         what the session began with; or: new
//   # original PATH              the content of that file, as the session read it, is in PATH
//   # file 84 1764316800 5 0123456789abcdef    what the document's file was like when the edits that follow were made:
//                                FileState::text()
//   split 3-7                    an edit, as the log of the session has it
//   # saving /home/me/out.obj    from here on that file may be another, until it is said to be saved
//   # saved /home/me/out.obj     nothing is unsaved at this point, and this is the document's file
//   # unsaved 1 2                what the file does not hold: 1 edit, and 2 of its edits are undone; said where it
//                                is not one edit more than before
#pragma once

#include <cstdint>
#include <ctime>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/editor/commands/text/script.h"
#include "ryosen/document/document.h"

namespace ryosen {

class Session;

// $XDG_STATE_HOME/ryosen/recovery, or ~/.local/state/ryosen/recovery; empty if neither variable is an absolute path.
std::filesystem::path recovery_folder();

// The start state of a session.
struct SessionStart {
  std::filesystem::path file;      // absolute; empty: an empty mesh
  std::filesystem::path original;  // the copy of its content, if the file has been replaced since; else empty
  std::uint64_t hash = 0;          // of the mesh
  FileState state{};               // of the file when it was read; not known of a lost session
};

struct LostSession {
  std::filesystem::path script;
  SessionStart start;
  std::filesystem::path file;     // the document's; empty if it has none
  std::vector<ScriptLine> edits;  // all of them, with their lines in the script
  std::size_t saved_edits = 0;    // number of them before the last save
  Document::Unsaved unsaved;
  FileState known;                                     // what the document's file was like when the edits were made
  bool was_saving = false;                             // it ended while it saved
  FileState::Change change = FileState::Change::none;  // of that file since, as it was listed
  std::size_t whole_bytes = 0;                         // size of the complete lines; an incomplete last line follows
  std::time_t last_edit = 0;

  bool is_saved() const { return saved_edits == edits.size(); }
};

// The mesh on which the edits of a lost session are replayed when the document's file has changed since.
enum class RecoverOnto {
  unchanged,  // there is no such difference, else nothing is done
  as_was,  // the mesh that they were made on; the document knows its file as it was then, so that no save replaces it
           // unasked
  as_is,   // the file as it is now
};
// Whether the edits can be done on the mesh that they were made on: there is a copy of it, or nothing else to begin
// with.
bool can_be_as_was(const LostSession& lost);
// Whether they can be done on the file as it is now: none was saved, and the file is there.
bool can_be_as_is(const LostSession& lost);

// Parses a session script; `script`, `change` and `last_edit` are not set. None if it is not a session script.
std::optional<LostSession> read_lost_session(std::string_view script);
// The crashed sessions with unsaved edits, latest first. Scripts without unsaved edits are deleted; scripts locked by a
// running process and other files are left alone. A folder that is not there has none; one that may not be read is a
// failure.
Result<std::vector<LostSession>> find_lost_sessions(const std::filesystem::path& folder);
// Lists them anew in the session; on failure there are none.
Status list_lost_sessions(std::vector<LostSession>& lost);
Text nothing_to_recover();
// "in.obj, 3 edits, 2026-11-21 20:15"
Text describe(const LostSession& lost);

// Replaces the session's document by the start mesh with the edits replayed. The document is then unsaved. If its file
// or the start mesh has changed, that is refused before anything is replayed, unless `onto` says on what. Replay stops
// at the first edit that fails: the outcome names its script line, the earlier edits are applied, and the script stays.
// A session with autosave continues this script; otherwise the script stays too. Fails, leaving the session unchanged,
// if the mesh cannot be read or another process has locked the script.
Outcome recover(Session& session, const LostSession& lost, RecoverOnto onto = RecoverOnto::unchanged);
// "Another program has changed a.off since these edits were made." Empty where none has.
Text told_change(const LostSession& lost, FileState::Change change);
// Deletes the script. Fails if it is gone or locked by another process.
Outcome discard(const LostSession& lost);

// Whether a line of a log changes the mesh, by its row: an edit, or a step through the history.
bool is_edit(std::string_view line);

}  // namespace ryosen
