#include "app/editor/commands/commands.h"

#include <algorithm>
#include <charconv>
#include <list>
#include <map>
#include <mutex>

#include "app/editor/commands/command_functions.h"
#include "app/editor/commands/text/script.h"
#include "app/editor/commands/text/words.h"
#include "ryosen/algo/algorithm_table.h"
#include "ryosen/base/rows.h"

namespace ryosen {

namespace {

// The rows of ScopedCommand. A list, since calls point at them.
std::list<CommandRow>& scoped_rows() {
  static std::list<CommandRow> rows;
  return rows;
}

// The row that is made from one of another table, called by a word, when it is first asked for. An operator has one per
// id and alias, since its messages name the word used. The row of a ScopedAlgorithm or ScopedViewSwitch stays behind.
template <class Row>
const CommandRow* made_row(std::string_view word, const Row& of, auto make) {
  static std::map<std::pair<std::string, const Row*>, CommandRow> rows;
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  std::pair<std::string, const Row*> key(word, &of);
  const auto found = rows.find(key);
  return &(found != rows.end() ? found : rows.emplace(std::move(key), make()).first)->second;
}

const CommandRow* made_row(const OpInfo& op, std::string_view word) {
  return made_row(word, op, [&] { return row_of(op, word); });
}
const CommandRow* made_row(const ViewSwitch& row) {
  return made_row(row.id, row, [&] { return row_of(row); });
}
const CommandRow* made_row(const AlgorithmRow& row) {
  return made_row(row.id, row, [&] { return row_of(row); });
}

}  // namespace

ScopedCommand::ScopedCommand(CommandRow row) { scoped_rows().push_back(std::move(row)); }
ScopedCommand::~ScopedCommand() { scoped_rows().pop_back(); }

std::vector<const CommandRow*> command_table() {
  std::vector<const CommandRow*> table;
  for (const OpInfo& op : all_ops()) table.push_back(made_row(op, op.id));
  for (const CommandRow& row : first_command_rows()) table.push_back(&row);
  for (const ViewSwitch& row : view_switches()) table.push_back(made_row(row));
  for (const CommandRow& row : last_command_rows()) table.push_back(&row);
  for (const AlgorithmRow& algorithm : algorithm_table())
    if (!find_op(algorithm.id)) table.push_back(made_row(algorithm));
  for (const CommandRow& row : scoped_rows()) table.push_back(&row);
  return table;
}

const CommandRow* find_command_row(std::string_view id) {
  for (const std::vector<CommandRow>* rows : {&first_command_rows(), &last_command_rows()})
    if (const CommandRow* const row = find_row(*rows, id)) return row;
  if (const OpInfo* const op = find_op(id)) return made_row(*op, id);
  if (const ViewSwitch* const row = find_view_switch(id)) return made_row(*row);
  if (const AlgorithmRow* const algorithm = find_algorithm(id)) return made_row(*algorithm);
  return find_row(scoped_rows(), id);
}

const CommandRow* row_of(const Command& command) {
  if (const AnyOp* const op = command.op()) return made_row(info_of(*op), info_of(*op).id);
  if (const AlgorithmCall* const call = command.algorithm())
    return call->is_called_repair || find_op(call->row->id) ? find_command_row("repair") : made_row(*call->row);
  const std::vector<std::string_view> words = split_words(*command.written());
  return words.empty() ? nullptr : find_command_row(words[0]);
}

Effect effect_of(const CommandRow& row, Words arguments) {
  return row.only_tells && row.only_tells(arguments) ? Effect::view : row.effect;
}

std::optional<CommandCall> call_of(std::string_view line) {
  const std::vector<std::string_view> words = split_words(line);
  const CommandRow* const row = words.empty() ? nullptr : find_command_row(words[0]);
  if (!row) return std::nullopt;
  const Words arguments = Words(words).subspan(1);
  if (const std::string sent = row->sends ? row->sends(arguments) : ""; !sent.empty()) return call_of(sent);
  const bool only_tells = row->only_tells && row->only_tells(arguments);
  const bool is_long = (row->is_long && !only_tells) || (row->may_take_long && row->may_take_long(arguments));
  return CommandCall{row, effect_of(*row, arguments), is_long, std::string(line)};
}

std::optional<CommandCall> call_of_command(const Command& command) {
  if (const std::string* const line = command.written()) return call_of(*line);
  const CommandRow& row = *row_of(command);
  return CommandCall{&row, row.effect, row.is_long, {}};
}

std::string file_of(const CommandCall& call) {
  if (call.row->file == FileAccess::none) return {};
  return file_name(behind_word(call.line));
}

Outcome wrong_arguments(std::string_view id) {
  const auto row = find_command_row(id);
  const std::string form = std::string(id) + (row->syntax.empty() ? "" : " " + std::string(row->syntax));
  return usage_error("the command reads: " + form, "書式：" + form);
}

std::optional<Text> fault_unless(bool has_form, std::string_view id) {
  return has_form ? std::nullopt : std::optional(wrong_arguments(id).sentence);
}

std::function<std::optional<Text>(Words arguments, const std::string& line)> takes_words(std::string_view id) {
  return [id](Words arguments, const std::string&) { return fault_unless(!arguments.empty(), id); };
}

std::optional<std::uint32_t> count_of(Words arguments) {
  if (arguments.empty()) return 1;
  const std::string_view word = arguments[0];
  std::uint32_t n = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), n);
  const bool is_count = error == std::errc() && end == word.data() + word.size() && n > 0 && arguments.size() == 1;
  return is_count ? std::optional(n) : std::nullopt;
}

std::string help_of(const CommandRow& row, Language language) {
  std::string help(language == Language::japanese ? row.help_ja : row.help_en);
  if (row.ids && language == Language::japanese) help += "。ID：" + row.ids();
  if (row.ids && language == Language::english) help += "; ID: " + row.ids();
  return help;
}

std::vector<std::string> command_ids() {
  std::vector<std::string> ids;
  for (const CommandRow* row : command_table()) {
    ids.emplace_back(row->id);
    for (std::string_view alias : split_words(row->aliases)) ids.emplace_back(alias);
  }
  return ids;
}

Outcome unknown_command(std::string_view id) {
  const std::string wrong(id);
  return usage_error(Text{"there is no command '" + wrong + "'", "コマンド「" + wrong + "」はありません"} +
                     did_you_mean(id, command_ids()));
}

Text not_an_operator(std::string_view word) {
  std::vector<std::string> ids;
  for (const OpInfo& op : all_ops()) add_ids(op, ids);
  const std::string wrong(word);
  return Text{"'" + wrong + "' is not an operator", "「" + wrong + "」は演算子ではありません"} +
         did_you_mean(word, ids);
}

Text name_of_command(std::string_view id) {
  if (const OpInfo* const op = find_op(id)) return {std::string(op->name_en), std::string(op->name_ja)};
  if (const AlgorithmRow* const row = find_algorithm(id)) return {std::string(row->name_en), std::string(row->name_ja)};
  return {std::string(id), std::string(id)};
}

Text name_of_line(std::string_view line) {
  const std::string_view id = line.substr(0, line.find(' '));
  if (const auto row = find_command_row(id))
    for (const NamedCall& call : row->named)
      if (call.line == line) return {std::string(call.en), std::string(call.ja)};
  return name_of_command(id);
}

}  // namespace ryosen
