#include "app/cli/run.h"

#include <cstdio>
#include <exception>

#include "app/cli/command_line.h"
#include "app/cli/subcommands.h"

namespace ryosen::cli {

namespace {

ExitCode run_command(const CommandLine& line) {
  if (line.wants_help) return show_help(line.command, line.console);
  if (line.failure) {
    const ExitCode code = line.console.fail(*line.failure);
    std::string help = "ryosen help";
    if (line.command) help.append(" ").append(line.command->id);
    line.console.note({"See: " + help, "使い方は " + help + " で見られます。"});
    return code;
  }
  // Without a command: the editor.
  return (line.command ? line.command : find_subcommand("view"))->run(line.arguments, line.console);
}

// Output may still be buffered; a full disk is detected only here.
ExitCode finish_output(const Console& console, ExitCode code) {
  if (std::fflush(stdout) == 0 && !std::ferror(stdout)) return code;
  const Failure failure = make_failure(ExitCode::output_not_writable, "output_not_writable",
                                       {"The output cannot be written.", "出力を書き込めません。"});
  console.show(failure.message);
  return failure.exit_code;
}

}  // namespace

ExitCode run(const std::vector<std::string>& arguments) noexcept {
  CommandLine line;
  try {
    line = read_command_line(arguments);
    return finish_output(line.console, run_command(line));
  } catch (const std::exception& error) {
    const std::string what = error.what();
    return line.console.fail(
        make_failure(ExitCode::internal_error, "internal_error", {"Internal error: " + what, "内部エラー：" + what}));
  }
}

}  // namespace ryosen::cli
