// `help` and `--version`, read from the table of commands.
#include "app/cli/columns.h"
#include "app/cli/did_you_mean.h"
#include "app/cli/json.h"
#include "app/cli/subcommands.h"

namespace ryosen::cli {

namespace {

struct ExitCodeText {
  ExitCode code;
  std::string_view en, ja;
};

constexpr ExitCodeText exit_codes[] = {
    {ExitCode::done, "done, nothing found", "完了、問題なし"},
    {ExitCode::found_problems, "done; problems or differences found, or a failed expect",
     "完了、問題・差異あり、または expect の不一致"},
    {ExitCode::usage, "usage, a line that does not parse, an element that never existed",
     "使い方の誤り、解釈できない行、存在したことのない要素"},
    {ExitCode::input_missing, "input missing or unreadable", "入力がない、または読めない"},
    {ExitCode::input_malformed, "input malformed", "入力の内容が不正"},
    {ExitCode::output_not_writable, "output not writable", "出力を書き込めない"},
    {ExitCode::refused, "operation refused", "操作を実行できない"},
    {ExitCode::no_backend, "no display or no render backend", "画面または描画バックエンドがない"},
    {ExitCode::cancelled, "cancelled", "中止された"},
    {ExitCode::some_inputs_failed, "some of several inputs failed", "複数の入力の一部が失敗"},
    {ExitCode::internal_error, "internal error", "内部エラー"},
};

std::string usage_of(const Subcommand& command) {
  std::string usage = "ryosen " + std::string(command.id);
  if (!command.operands.empty()) usage += " " + std::string(command.operands);
  return usage;
}

std::string flag_texts(std::span<const Flag> flags, const Console& console) {
  Columns columns;
  for (const Flag& flag : flags) {
    std::string left(flag.name);
    if (!flag.value.empty()) left += " " + std::string(flag.value);
    columns.add(std::move(left), console.text(flag.en, flag.ja));
  }
  return columns.text();
}

std::string help_of(const Subcommand& command, const Console& console) {
  std::string text = usage_of(command) + "\n" + std::string(console.text(command.en, command.ja)) + "\n";
  if (!command.flags.empty()) text += "\n" + flag_texts(command.flags, console);
  text += "\n" + std::string(console.text("Common:", "共通：")) + "\n" + flag_texts(common_flags(), console);
  if (command.more) text += "\n" + command.more(console.language);
  return text;
}

std::string help_of_program(const Console& console) {
  std::string text(console.text("Ryosen: a halfedge mesh editor that explains itself\n\n",
                                "Ryosen（稜線）：理由を説明するハーフエッジ・メッシュエディタ\n\n"));
  Columns columns, algorithms;
  for (const Subcommand& command : subcommands())
    (command.is_algorithm ? algorithms : columns).add(usage_of(command), console.text(command.en, command.ja));
  text += columns.text() + "\n" + std::string(console.text("Algorithms:", "アルゴリズム：")) + "\n" + algorithms.text();
  text += "\n" + std::string(console.text("Common:", "共通：")) + "\n" + flag_texts(common_flags(), console);
  text += "\n" + std::string(console.text("Exit codes:", "終了コード：")) + "\n";
  Columns codes;
  for (const ExitCodeText& row : exit_codes)
    codes.add(std::to_string(static_cast<int>(row.code)), console.text(row.en, row.ja));
  return text + codes.text();
}

Json to_json(std::span<const Flag> flags) {
  Json all = Json::array();
  for (const Flag& flag : flags)
    all.push_back({{"flag", flag.name},
                   {"value", flag.value.empty() ? Json() : Json(flag.value)},
                   {"repeatable", flag.repeatable},
                   {"en", flag.en},
                   {"ja", flag.ja}});
  return all;
}

Json to_json(const Subcommand& command) {
  return {{"command", command.id},
          {"operands", command.operands},
          {"flags", to_json(command.flags)},
          {"en", command.en},
          {"ja", command.ja}};
}

}  // namespace

ExitCode show_help(const std::optional<Subcommand>& command, const Console& console) {
  if (console.json) {
    for (const Subcommand& row : subcommands())
      if (!command || command->id == row.id) console.print(line_of(to_json(row)));
  } else {
    console.print(command ? help_of(*command, console) : help_of_program(console));
  }
  return ExitCode::done;
}

ExitCode help_command(const Arguments& arguments, const Console& console) {
  if (arguments.operands().empty()) return show_help(std::nullopt, console);
  const std::string& name = arguments.operands()[0];
  if (const auto command = find_subcommand(name)) return show_help(command, console);
  std::vector<std::string> known;
  for (const Subcommand& command : subcommands()) known.emplace_back(command.id);
  const Text hint = did_you_mean(name, known);
  return console.fail(usage_failure("unknown_command", {"'" + name + "' is not a command." + hint.en,
                                                        "「" + name + "」というコマンドはありません。" + hint.ja}));
}

ExitCode version_command(const Arguments&, const Console& console) {
  console.print(console.json ? line_of({{"version", RYOSEN_VERSION}}) : "ryosen " RYOSEN_VERSION "\n");
  return ExitCode::done;
}

}  // namespace ryosen::cli
