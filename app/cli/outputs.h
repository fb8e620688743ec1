// A command's output files: checked before anything runs, and written.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/cli/console.h"
#include "app/cli/subcommand_table.h"
#include "app/editor/document/run_files.h"
#include "ryosen/document/document.h"

namespace ryosen::cli {

// The files of a run that begins with this input, or with none where it is empty; --overwrite is heeded.
RunFiles files_of_run(const Arguments& arguments, const std::string& input);

// Refuses a name that does not tell the format. A pipe, a device or standard output without an extension gets the
// format of the input, if `has_input`.
std::optional<Failure> fault_of_output(const std::string& path, bool has_input);

struct WrittenOutput {
  bool is_there = false;        // the new file is in place, even if a later step failed
  std::vector<Message> losses;  // what it cannot represent; empty if writing failed
  std::optional<Failure> failure;
};

// The mesh of -o. Shows the losses and the failure. is_strict: losses are a failure. `given_up`: losses that the
// document no longer knows of (give_up_lost_elements), which come first.
WrittenOutput write_output(Document& document, RunFiles& files, const std::string& path, bool is_strict,
                           const Console& console, const std::vector<Message>& given_up = {});

// "written: o.obj", or that nothing was where there is no path, with the line end.
std::string written_text(const std::string* path, const Console& console);

}  // namespace ryosen::cli
