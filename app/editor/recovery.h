// Brings back what a session did and had not saved when the program crashed. A script of its edits lies in a folder of
// the user's (see autosave.h); one that nobody owns any more is of a session that was lost.
//
// The script is one that `ryosen edit --new --script` could run, with remarks:
//   # ryosen session 1
//   # mesh 0123456789abcdef      the hash of the mesh before the first edit
//   open /home/me/in.obj         what the session began with; or: new
//   # original PATH              from here on that file is another; its old content is in PATH
//   split 3-7                    an edit, as the log of the session has it
//   # saved /home/me/out.obj     nothing is unsaved at this point, and this is the document's file
#pragma once

#include <cstdint>
#include <ctime>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/editor/document.h"
#include "app/editor/script.h"

namespace ryosen {

class Session;

// $XDG_STATE_HOME/ryosen/recovery, or ~/.local/state/ryosen/recovery; empty where neither variable holds a whole path.
std::filesystem::path recovery_folder();

// What a session began with.
struct SessionStart {
  std::filesystem::path file;      // absolute; empty: an empty mesh
  std::filesystem::path original;  // where its content is kept if the file has another since; else empty
  std::uint64_t hash = 0;          // of the mesh
};

struct LostSession {
  std::filesystem::path script;
  SessionStart start;
  std::filesystem::path file;     // the document's; empty where it has none
  std::vector<ScriptLine> edits;  // all of them, with their lines in the script
  std::size_t unsaved = 0;        // how many of them after the last save
  std::size_t whole_bytes = 0;    // of the script; a line that was begun when the program crashed lies behind them
  std::time_t last_edit = 0;
};

// The session that a script tells of, without `script` and `last_edit`; nothing where it is no script of a session.
std::optional<LostSession> read_lost_session(std::string_view script);
// Those of which something is unsaved, the latest first. Scripts of which nothing is are taken away; what a running
// process owns, and what is no such script, is left alone. A folder that is not there has none; one that may not be read is
// a failure.
Result<std::vector<LostSession>> find_lost_sessions(const std::filesystem::path& folder);
// Lists them anew in the session; on failure there are none.
Status list_lost_sessions(Session& session);
// "in.obj, 3 edits, 2026-11-21 20:15"
Text describe(const LostSession& lost);

// Takes the place of the session's document: the mesh that it began with, and the edits done again one after the other.
// The document is unsaved then. A mesh that is not the one of that time is said. An edit that cannot be done again ends
// it: the outcome names the script's line, the edits before it are done, and the script stays. Where the session keeps a
// script of its own, it goes on with this one; else the script stays too. Fails, and leaves the session as it was, where
// the mesh cannot be read or somebody else has the script.
Outcome recover(Session& session, const LostSession& lost);
// Takes the script away. Fails where it is gone or somebody else has it.
Outcome discard(const LostSession& lost);

// Whether a line of a log changes the mesh, by its row: an edit, or a step through the history.
bool is_edit(std::string_view line);

}  // namespace ryosen
