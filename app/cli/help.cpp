// `help` and `--version`, read from the table of commands.
#include <algorithm>

#include "app/cli/columns.h"
#include "app/cli/contract/json.h"
#include "app/cli/contract/lists.h"
#include "app/cli/help_topics.h"
#include "app/cli/id_lists.h"
#include "app/cli/subcommand_table.h"
#include "app/editor/commands/text/script.h"
#include "ryosen/base/enum_table.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/ops/all.h"

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
  for (const IdEntry& row : list_of(Ids::exit_codes).entries()) codes.add(row.id, console.text(row.text));
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
  json["flags"] = array_of(command.flags, [](const Flag& flag) { return to_json(flag); });
  json.put(command.en, command.ja);
  return line_of(json);
}

struct PrintedObject {
  const Shape* shape;
  bool is_line;
};

void add_object(const Shape& shape, bool is_line, std::vector<PrintedObject>& all) {
  if (std::any_of(all.begin(), all.end(), [&](const PrintedObject& known) { return known.shape == &shape; })) return;
  all.push_back({&shape, is_line});
  for (const JsonKey& key : shape.all_keys())
    if (key.limits.shape) add_object(*key.limits.shape, false, all);
}

// Lines, each before the objects that it holds.
std::vector<PrintedObject> objects_of(const Contract& contract, const std::vector<PrintedObject>& known = {}) {
  std::vector<PrintedObject> all = known;
  for (const Shape* shape : contract.lines)
    if (shape) add_object(*shape, true, all);
  all.erase(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(known.size()));
  return all;
}

std::vector<int> exits_of(const Contract& contract) {
  std::vector<int> codes;
  for (const Contract& part : {shared_contract, contract})
    for (ExitCode code : part.exits) codes.push_back(static_cast<int>(code));
  sort_unique(codes);
  return codes;
}

Json described(const JsonKey& row) {
  Record<key_shape> json;
  json["key"] = row.id;
  json["type"] = row.type;
  json["optional"] = row.limits.is_optional;
  json["object"] = row.limits.shape ? Json(row.limits.shape->id) : Json();
  json["words"] = row.limits.words.empty() ? Json() : Json(split_words(row.limits.words));
  json["list"] = row.limits.ids ? Json(list_of(*row.limits.ids).id) : Json();
  json.put(row.en, row.ja);
  return std::move(json).json();
}

Json described(const PrintedObject& object) {
  Record<object_shape> json;
  json["object"] = object.shape->id;
  json["is_line"] = object.is_line;
  json.put(object.shape->en, object.shape->ja);
  json["keys"] = array_of(object.shape->all_keys(), [](const JsonKey& row) { return described(row); });
  return std::move(json).json();
}

std::string contract_line(const Json& command, const std::vector<PrintedObject>& printed, const Contract& contract) {
  Record<contract_shape> json;
  json["command"] = command;
  json["objects"] = array_of(printed, [](const PrintedObject& object) { return described(object); });
  json["exit_codes"] = exits_of(contract);
  return line_of(json);
}

std::vector<Json> places_of(const OpLine& line) {
  // Names in the order of OpValueKind and of OpParameter::Need.
  constexpr const char* kinds[] = {"vertex", "edge", "face", "number", "position", "word"};
  constexpr const char* needs[] = {"required", "optional", "list"};
  static_assert(std::size(kinds) == enum_count<OpValueKind> && std::size(needs) == enum_count<OpParameter::Need>);
  std::vector<Json> places;
  for (std::size_t i = 0; i < line.all_lists().size(); ++i)
    for (const OpParameter& parameter : line.lists[i]) {
      Record<place_shape> place;
      place["id"] = parameter.id;
      place["list"] = i;
      place["need"] = needs[static_cast<std::size_t>(parameter.need)];
      place["values"] = Json::array();
      for (const OpValue& value : std::span(parameter.values).first(parameter.count())) {
        Record<value_shape> json;
        json["kind"] = kinds[static_cast<std::size_t>(value.kind)];
        json["called"] = value.called;
        place["values"].push_back(std::move(json).json());
      }
      place.put(parameter.help_en, parameter.help_ja);
      places.push_back(std::move(place).json());
    }
  return places;
}

std::string list_line(const IdList& list) {
  Record<list_shape> json;
  json["list"] = list.id;
  json.put(list.en, list.ja);
  json["entries"] = Json::array();
  for (const IdEntry& row : list.entries()) {
    Record<entry_shape> entry;
    entry["id"] = row.id;
    if (row.syntax) entry["syntax"] = *row.syntax;
    if (row.line) entry["places"] = places_of(*row.line);
    if (!row.severities.empty()) entry["severities"] = row.severities;
    entry.put(row.text);
    json["entries"].push_back(std::move(entry).json());
  }
  return line_of(json);
}

// The type of a key with what limits it, as in "array of object (message)".
std::string type_text(const JsonKey& row) {
  std::string text(row.type), limits;
  const auto add = [&](std::string_view limit) { limits.append(limits.empty() ? " (" : ", ").append(limit); };
  if (row.limits.shape) add(row.limits.shape->id);
  for (const std::string_view word : split_words(row.limits.words)) add(word);
  if (row.limits.ids) add(list_of(*row.limits.ids).id);
  return text + limits + (limits.empty() ? "" : ")");
}

std::string objects_text(const std::vector<PrintedObject>& printed, const Console& console) {
  std::string text;
  for (const PrintedObject& object : printed) {
    text.append("\n").append(object.is_line ? "" : "  ").append(object.shape->id).append(console.text(": ", "："));
    text.append(console.text(object.shape->en, object.shape->ja)).append("\n");
    Columns columns;
    for (const JsonKey& row : object.shape->all_keys())
      columns.add(std::string(row.id) + (row.limits.is_optional ? "?" : ""),
                  type_text(row) + std::string(console.text(". ", "。")) + std::string(console.text(row.en, row.ja)));
    text += columns.text();
  }
  return text;
}

std::string exits_text(const Contract& contract, const Console& console) {
  std::string text(console.text("exit codes:", "終了コード："));
  for (const int code : exits_of(contract)) text += " " + std::to_string(code);
  return text + "\n";
}

std::string list_text(const IdList& list, const Console& console) {
  Columns columns;
  for (const IdEntry& row : list.entries()) {
    std::string severities;
    for (const std::string_view severity : row.severities)
      severities.append(severities.empty() ? "" : ", ") += severity;
    columns.add(row.id + (severities.empty() ? "" : " (" + severities + ")"), console.text(row.text));
  }
  return "\n" + std::string(list.id) + std::string(console.text(": ", "：")) +
         std::string(console.text(list.en, list.ja)) + "\n" + columns.text();
}

std::string contract_text(const Console& console) {
  const std::vector<PrintedObject> shared = objects_of(shared_contract);
  std::string text(console.text(
      "What --json prints: one object per line. A key that may be absent is marked by ?; behind the type stand the "
      "kind\n"
      "of the objects in it, the only words that it holds, or the list below that they are of.\n\nEvery command, ",
      "--json の出力：一行に一つのオブジェクト。? はないことのあるキー。型の後の括弧は、中のオブジェクトの種類、\n"
      "とりうる語、または下の一覧の名前。\n\nすべてのコマンド、"));
  text += exits_text(shared_contract, console) + objects_text(shared, console);
  for (const Subcommand& command : subcommands())
    text += "\n" + std::string(command.id) + std::string(console.text(", ", "、")) +
            exits_text(command.contract, console) + objects_text(objects_of(command.contract, shared), console);
  for (const IdList& list : id_lists()) text += list_text(list, console);
  return text;
}

// `help json`: every key and code that the program prints, with its meaning.
void show_contract(const Console& console) {
  if (!console.json) return console.print(contract_text(console));
  const std::vector<PrintedObject> shared = objects_of(shared_contract);
  console.print(contract_line(nullptr, shared, shared_contract));
  for (const Subcommand& command : subcommands())
    console.print(contract_line(command.id, objects_of(command.contract, shared), command.contract));
  for (const IdList& list : id_lists()) console.print(list_line(list));
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
