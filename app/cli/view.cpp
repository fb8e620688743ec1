// `view`: the editor's window.
#include "app/cli/subcommand_table.h"
#include "app/window/window.h"

namespace ryosen::cli {

ExitCode view_command(const Arguments& arguments, const Console& console) {
  WindowOptions options;
  if (!arguments.operands().empty()) options.file = arguments.operands()[0];
  options.usual_language = console.language;
  if (arguments.has("--lang")) options.language = console.language;
  if (const auto* file = arguments.value("--preferences")) options.preferences = *file;
  const Status status = run_window(options);
  if (status) return ExitCode::done;
  const bool is_about_file = status.failure().exit_code != ExitCode::no_backend;
  if (!is_about_file) return console.fail(status.failure());
  return console.fail(status.failure(), options.file.string());
}

}  // namespace ryosen::cli
