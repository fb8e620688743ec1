// The commands of `edit` and `shot`, and the checks made before the first of them runs.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/editor/commands/text/script.h"
#include "app/editor/document/run_files.h"
#include "ryosen/base/result.h"

namespace ryosen::cli {

struct EditScript {
  std::vector<ScriptLine> lines;
  std::string file;  // where they were read from; empty for lines of the command line

  // What messages about a line name as its place.
  std::string_view place() const { return file.empty() ? std::string_view("--do") : file; }
};

// From the script file, or else from the given lines, which are numbered one after the other.
Result<EditScript> read_edit_script(const std::string* script_file, const std::vector<std::string>& lines);

// A file that is written after the script has run.
struct PlannedOutput {
  std::string path;
  FileRole role;
};

// The first fault that shows without a mesh: a line that is wrong on every mesh, an output in an unknown format, or a
// file that the run must not replace. `files` has the files that are read, but for those that the script opens; what
// the run would write is added. `input` is empty where the script begins without one.
std::optional<Failure> find_fault(const EditScript& script, const std::string& input,
                                  const std::vector<PlannedOutput>& outputs, RunFiles& files);

}  // namespace ryosen::cli
