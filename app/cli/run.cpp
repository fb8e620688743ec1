#include "app/cli/run.h"

#include <exception>
#include <filesystem>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/console.h"
#include "app/cli/subcommand_table.h"
#include "app/cli/sudden_end.h"
#include "app/editor/commands/text/script.h"
#include "ryosen/algo/algorithm_table.h"
#include "ryosen/io/safe_write.h"

namespace ryosen::cli {

namespace {

struct CommandLine {
  std::optional<Subcommand> command;
  Arguments arguments;
  Console console;  // set as far as possible even on failure
  std::optional<Failure> failure;
  bool wants_help = false;
};

std::string in_quotes(std::string_view word) { return "'" + std::string(word) + "'"; }

// Parses the program's arguments by the table of commands. Common flags may precede the command, all flags may occur
// anywhere after it; `--` ends them. `--flag=value` and `--flag value` are the same.
class Reader {
 public:
  explicit Reader(const std::vector<std::string>& words) : words_(words) {
    line_.console.language = language_of_environment();
  }

  CommandLine read() {
    for (; next_ < words_.size(); ++next_) {
      const std::string& word = words_[next_];
      if (!flags_ended_ && word == "--")
        flags_ended_ = true;
      else if (!flags_ended_ && word.size() > 1 && word[0] == '-' && !is_command_named_like_flag(word))
        read_flag(word);
      else if (!command_seen_)
        read_command(word);
      else
        line_.arguments.add_operand(word);
    }
    apply_common_flags();
    if (line_.command && !line_.wants_help) check_operands();
    return std::move(line_);
  }

 private:
  void fail(Code code, Text text) {
    if (!line_.failure) line_.failure = usage_failure(code, std::move(text));
  }

  // `--version` is a command; `help` takes it as an operand.
  bool is_command_named_like_flag(const std::string& word) const {
    return find_subcommand(word) && (!command_seen_ || (line_.command && line_.command->operand_is_command));
  }

  void read_command(const std::string& word) {
    command_seen_ = true;
    line_.command = find_subcommand(word);
    if (line_.command) return;
    const bool is_file = word.find_first_of("./\\") != std::string::npos || std::filesystem::exists(word);
    if (is_file) {
      line_.command = find_subcommand("view");
      line_.arguments.add_operand(word);
      return;
    }
    std::vector<std::string> known;
    for (const Subcommand& command : subcommands()) known.emplace_back(command.id);
    fail("unknown_command",
         Text{in_quotes(word) + " is not a command.", "「" + word + "」というコマンドはありません。"} +
             did_you_mean(word, known, HintForm::sentence));
  }

  const Flag* find_flag(std::string_view name) const {
    if (line_.command)
      for (const Flag& flag : line_.command->flags)
        if (flag.name == name) return &flag;
    for (const Flag& flag : common_flags())
      if (flag.name == name) return &flag;
    return nullptr;
  }

  void read_flag(const std::string& word) {
    const std::size_t equals = word.starts_with("--") ? word.find('=') : std::string::npos;
    const std::string name = word.substr(0, equals);
    const Flag* const flag = find_flag(name);
    if (!flag) return unknown_flag(name);
    const bool has_value = equals != std::string::npos;
    if (flag->value.empty()) {
      if (has_value)
        fail("flag_takes_no_value", {name + " takes no value.", name + " は値を取りません。"});
      else
        line_.arguments.add_flag(*flag, {});
      return;
    }
    if (flag->may_lack_value() && !has_value && !next_is_value_of(*flag)) {
      if (line_.arguments.has(flag->name)) fail_repeated(name);
      return line_.arguments.add_flag(*flag, {});
    }
    if (!has_value && (next_ + 1 == words_.size() || find_flag(words_[next_ + 1]))) {
      const std::string expected(flag->value);
      return fail("value_missing", {name + " needs a value: " + expected, name + " には値が必要です：" + expected});
    }
    if (!flag->repeatable && line_.arguments.has(flag->name)) fail_repeated(name);
    line_.arguments.add_flag(*flag, has_value ? word.substr(equals + 1) : words_[++next_]);
  }

  void fail_repeated(const std::string& name) {
    fail("flag_repeated", {name + " is given twice.", name + " が二度指定されています。"});
  }

  // Whether the next word is one of those in the brackets of a value that may be left out.
  bool next_is_value_of(const Flag& flag) const {
    if (next_ + 1 == words_.size() || words_[next_ + 1].empty()) return false;
    const std::string all = "|" + flag.value.substr(1, flag.value.size() - 2) + "|";
    return all.find("|" + words_[next_ + 1] + "|") != std::string::npos;
  }

  void unknown_flag(const std::string& name) {
    std::vector<std::string> known;
    if (line_.command)
      for (const Flag& flag : line_.command->flags) known.emplace_back(flag.name);
    for (const Flag& flag : common_flags()) known.emplace_back(flag.name);
    const std::string command(line_.command ? line_.command->id : "ryosen");
    fail("unknown_flag", Text{command + " has no flag " + in_quotes(name) + ".",
                              command + " に「" + name + "」という指定はありません。"} +
                             did_you_mean(name, known, HintForm::sentence));
  }

  void apply_common_flags() {
    Console& console = line_.console;
    const Arguments& given = line_.arguments;
    console.json = given.has("--json");
    console.quiet = given.has("-q");
    console.verbose = given.has("-v");
    line_.wants_help = given.has("--help") || given.has("-h");
    const std::string* const language = given.value("--lang");
    if (!language) return;
    if (*language != "en" && *language != "ja")
      return fail("bad_value", {"--lang is en or ja, not " + in_quotes(*language) + ".",
                                "--lang は en か ja です（「" + *language + "」は使えません）。"});
    console.language = *language == "ja" ? Language::japanese : Language::english;
  }

  void check_operands() {
    const Subcommand& command = *line_.command;
    const std::size_t count = line_.arguments.operands().size();
    const std::string usage = "ryosen " + std::string(command.id) + " " + std::string(command.operands);
    if (count < command.least_operands())
      fail("operand_missing", {"Something is missing: " + usage, "引数が足りません：" + usage});
    if (count > command.most_operands()) {
      const std::string& first = line_.arguments.operands()[command.most_operands()];
      fail("operand_too_many", {in_quotes(first) + " is too much: " + usage, "「" + first + "」は余分です：" + usage});
    }
  }

  const std::vector<std::string>& words_;
  std::size_t next_ = 0;
  bool flags_ended_ = false;
  bool command_seen_ = false;
  CommandLine line_;
};

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
    line = Reader(arguments).read();
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
