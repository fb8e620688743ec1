// The editor's window: its OpenGL context, its events, and when it draws.
#pragma once

#include <filesystem>

#include "core/base/result.h"

namespace ryosen {

struct WindowOptions {
  std::filesystem::path file;  // empty: no mesh
  Language language = Language::english;
};

// Shows the editor until the user leaves it. Fails with ExitCode::no_backend where no window can be opened, and as
// Document::open does where the file cannot be read; then no window appears.
//
// Every edit is kept for after a crash (see editor/autosave.h); what an earlier one left is offered at the start.
//
// With RYOSEN_FRAME_LOG=FILE in the environment each picture shown adds a line to FILE: its number, how many pixels
// were drawn, how long it took, and the state of the document.
Status run_window(const WindowOptions& options);

}  // namespace ryosen
