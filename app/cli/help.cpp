// `help` and `--version`, read from the table of commands.
#include "app/cli/contract/help.h"
#include "app/cli/columns.h"
#include "app/cli/contract/lists.h"
#include "app/cli/contract/record.h"
#include "app/cli/exit_codes.h"
#include "app/cli/help_json.h"
#include "app/cli/help_topics.h"
#include "app/cli/subcommands.h"
#include "app/editor/commands/text/script.h"

namespace ryosen::cli {

namespace {

// What `help` knows besides commands.
constexpr std::string_view json_topic = "json", texts_topic = "texts";

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
                                "Ryosen（稜線）：理由を説明する半稜線メッシュエディタ\n\n"));
  Columns columns, algorithms;
  for (const Subcommand& command : subcommands())
    (command.is_algorithm ? algorithms : columns).add(usage_of(command), console.text(command.en, command.ja));
  text += columns.text() + "\n" + std::string(console.text("Algorithms:", "アルゴリズム：")) + "\n" + algorithms.text();
  text += "\n" + std::string(console.text("Common:", "共通：")) + "\n" + flag_texts(common_flags(), console);
  text += "\n" + std::string(console.text("Exit codes:", "終了コード：")) + "\n";
  Columns codes;
  for (const ExitCodeText& row : exit_code_texts())
    codes.add(std::to_string(static_cast<int>(row.code)), console.text(row.en, row.ja));
  return text + codes.text();
}

Json to_json(const Flag& flag) {
  Record<flag_shape> json;
  json["flag"] = flag.name;
  json["value"] = flag.value.empty() ? Json() : Json(flag.value);
  json["repeatable"] = flag.repeatable;
  json.put(flag.en, flag.ja);
  return std::move(json).json();
}

std::string json_line_of(const Subcommand& command) {
  Record<usage_shape> json;
  json["command"] = command.id;
  json["operands"] = command.operands;
  json["flags"] = Json::array();
  for (const Flag& flag : command.flags) json["flags"].push_back(to_json(flag));
  json.put(command.en, command.ja);
  return line_of(json);
}

}  // namespace

ExitCode show_help(const std::optional<Subcommand>& command, const Console& console) {
  if (console.json) {
    for (const Subcommand& row : subcommands())
      if (!command || command->id == row.id) console.print(json_line_of(row));
  } else {
    console.print(command ? help_of(*command, console) : help_of_program(console));
  }
  return ExitCode::done;
}

ExitCode help_command(const Arguments& arguments, const Console& console) {
  if (arguments.operands().empty()) return show_help(std::nullopt, console);
  const std::string& name = arguments.operands()[0];
  if (const auto command = find_subcommand(name)) return show_help(command, console);
  if (name == json_topic) {
    show_contract(console);
    return ExitCode::done;
  }
  if (name == texts_topic) {
    show_text_places(console);
    return ExitCode::done;
  }
  std::vector<std::string> known{std::string(json_topic), std::string(texts_topic)};
  for (const Subcommand& command : subcommands()) known.emplace_back(command.id);
  return console.fail(usage_failure(
      "unknown_command", Text{"'" + name + "' is not a command.", "「" + name + "」というコマンドはありません。"} +
                             did_you_mean(name, known, HintForm::sentence)));
}

ExitCode version_command(const Arguments&, const Console& console) {
  if (console.json) {
    Record<version_shape> json;
    json["version"] = RYOSEN_VERSION;
    console.print(line_of(json));
  } else {
    console.print("ryosen " RYOSEN_VERSION "\n");
  }
  return ExitCode::done;
}

}  // namespace ryosen::cli
