// The editor's window: its OpenGL context, its events, and when it draws.
#pragma once

#include <filesystem>
#include <optional>

#include "ryosen/base/result.h"

namespace ryosen {

struct WindowOptions {
  std::filesystem::path file;        // empty: no mesh
  std::optional<Language> language;  // what a flag says, else what the user prefers, else that of the environment
  Language usual_language = Language::english;
  std::filesystem::path preferences;  // a file in place of the user's own
};

// Runs the editor until the user quits. Fails with ExitCode::no_backend if no window can be opened, and like
// Document::open if the file cannot be read; then no window appears, or where that takes long one that says what is
// read, and closes.
//
// Preferences, the layout of the panels and the recent files are kept in the user's folder
// (app/editor/preferences/user_files.h).
//
// Every edit is recorded for crash recovery (app/editor/recovery/autosave.h); at the start, once the file is read,
// recoverable sessions are offered.
//
// With RYOSEN_FRAME_LOG=FILE in the environment a line of FILE says that a file is being read, and each presented frame
// appends a line to FILE: its number, the pixels drawn, the time taken, and the state of the document. Both name the
// panel that lies over the view.
Status run_window(const WindowOptions& options);

}  // namespace ryosen
