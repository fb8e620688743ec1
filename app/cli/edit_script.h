// The commands that `edit` is to run, and what can be said against them before any of them runs.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/editor/run_files.h"
#include "app/editor/script.h"
#include "core/base/result.h"

namespace ryosen::cli {

struct EditScript {
  std::vector<ScriptLine> lines;
  std::string file;  // where they were read from; empty for lines of the command line

  // What messages about a line name as its place.
  std::string_view place() const { return file.empty() ? std::string_view("--do") : file; }
};

// From the script file, or else from the given lines, which are numbered one after the other.
Result<EditScript> read_edit_script(const std::string* script_file, const std::vector<std::string>& lines);

// What is written when the script is through.
struct PlannedOutput {
  std::string path;
  FileRole role;
};

// A line that no mesh can make right, an output in no known format, or a file that the run must not replace: `files`
// knows what is read besides what the script opens, and knows then what would be written. `input` is empty where the
// script begins without one.
std::optional<Failure> find_fault(const EditScript& script, const std::string& input,
                                  const std::vector<PlannedOutput>& outputs, RunFiles& files);

}  // namespace ryosen::cli
