// A frontend (a window, a picture without a window, a script): what it can do for a session, and how it wants work.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "ryosen/base/progress.h"
#include "ryosen/document/document.h"

namespace ryosen {

class Autosave;
class Input;

struct Frontend {
  // Renders a picture of the session. Commands that need it fail if unset.
  std::function<Status(const std::filesystem::path&)> take_picture;
  // Gets the events that scripts send, where scripts run with panels. Where it is none, as in a window, which has
  // events of its own, the view gets them.
  std::weak_ptr<Input> input;
  // Reads files of meshes; a frontend that shows meanwhile what is read sets another way. One that was given up fails
  // as cancelled.
  std::function<Result<std::unique_ptr<Document>>(const std::filesystem::path&)> read_document = Document::open;
  // Is told of the progress of long operations, and may cancel them.
  Progress::Report on_progress;
  // Ends the session.
  std::function<void()> quit;
  // Crash recovery; null where there is none.
  Autosave* autosave = nullptr;
  bool is_strict = false;        // warnings refuse too
  bool begins_empty = false;     // somebody wants an empty mesh, not the start page
  bool awaits_file = false;      // a file is read just now: nothing is offered meanwhile
  bool asks_in_slices = false;   // verdicts of a tool on all elements are asked a slice at a time, in prepare()
  bool turns_to_solids = false;  // a new document is first seen from a side that shows its solids (framing.h)
};

}  // namespace ryosen
