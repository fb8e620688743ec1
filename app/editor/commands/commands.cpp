#include "app/editor/commands/commands.h"

#include <algorithm>
#include <charconv>

#include "app/editor/commands/command_functions.h"
#include "app/editor/commands/text/script.h"
#include "app/editor/commands/text/words.h"
#include "ryosen/algo/algorithm_table.h"

namespace ryosen {

Outcome wrong_arguments(std::string_view id) {
  const auto row = find_command_row(id);
  const std::string form = std::string(id) + (row->syntax.empty() ? "" : " " + std::string(row->syntax));
  return usage_error("the command reads: " + form, "書式：" + form);
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
