#include "app/cli/run.h"

#include <exception>
#include <new>

#include "app/cli/command_line.h"
#include "app/cli/last_words.h"
#include "app/cli/signals.h"
#include "app/cli/subcommands.h"
#include "app/cli/visible.h"
#include "ryosen/algo/algorithm_table.h"
#include "ryosen/io/safe_write.h"

namespace ryosen::cli {

namespace {

// What the command is about, where that is one file.
std::optional<std::string_view> file_of(const CommandLine& line) {
  const bool is_one = line.command && line.command->operands == "FILE" && line.arguments.operands().size() == 1;
  return is_one ? std::optional<std::string_view>(line.arguments.operands()[0]) : std::nullopt;
}

ExitCode run_command(const CommandLine& line) {
  const AlgorithmRow* const algorithm = line.command ? find_algorithm(line.command->id) : nullptr;
  prepare_last_words(line.console, file_of(line), algorithm && algorithm->has_goal);
  let_signals_in();
  if (line.wants_help) return show_help(line.command, line.console);
  if (line.failure) {
    const ExitCode code = line.console.fail(*line.failure);
    std::string help = "ryosen help";
    if (line.command) help.append(" ").append(line.command->id);
    line.console.note({"See: " + help, "使い方は " + help + " で見られます。"});
    return code;
  }
  // Without a command: the editor.
  const std::optional<Subcommand> command = line.command ? line.command : find_subcommand("view");
  if (command->is_window) end_window_by_signals();
  return command->run(line.arguments, line.console);
}

// Reports that the output cannot be written; the work itself stays done.
Text unwritable_stdout() {
  Text text{"Standard output cannot be written.", "標準出力に書き込めません。"};
  std::string names, names_ja;
  const std::vector<std::string> written = files_put_in_place();
  for (std::size_t i = 0; i < written.size(); ++i) {
    names += (i == 0 ? "" : i + 1 == written.size() ? " and " : ", ") + visible_line(written[i]);
    names_ja += (i == 0 ? "" : "、") + visible_line(written[i]);
  }
  if (written.empty()) return text;
  return {text.en + " " + names + (written.size() == 1 ? " is written." : " are written."),
          text.ja + names_ja + " は書き出しました。"};
}

// Output may still be buffered; a full disk is detected only here.
ExitCode finish_output(const Console& console, ExitCode code) {
  if (console.conclude({}, code)) return code;
  const Failure failure = make_failure(ExitCode::output_not_writable, "output_not_writable", unwritable_stdout());
  console.show(failure.message);
  return failure.exit_code;
}

}  // namespace

ExitCode run(const std::vector<std::string>& arguments) noexcept {
  CommandLine line;
  try {
    line = read_command_line(arguments);
    return finish_output(line.console, run_command(line));
  } catch (const std::bad_alloc&) {
    Console::flush();
    return say_last_words(LastWords::out_of_memory, true);
  } catch (const std::exception& error) {
    const std::string what = error.what();
    return line.console.fail(
        make_failure(ExitCode::internal_error, "internal_error", {"Internal error: " + what, "内部エラー：" + what}));
  }
}

}  // namespace ryosen::cli
