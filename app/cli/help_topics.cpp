#include "app/cli/help_topics.h"

#include <string_view>

#include "app/cli/algorithm_flags.h"
#include "app/cli/columns.h"
#include "app/cli/id_lists.h"
#include "app/editor/commands/commands.h"
#include "app/editor/recovery/recovery.h"
#include "ryosen/algo/algorithm_table.h"
#include "ryosen/scene/highlights/highlight_table.h"

namespace ryosen::cli {

namespace {

// With what its line may tell it besides elements, behind the words that the syntax has for that.
std::string help_of(const OpInfo& op, Language language) {
  std::string help(choose(language, op.help_en, op.help_ja));
  for (const OpParameters& list : op.line.all_lists())
    for (const OpParameter& place : list) {
      const std::string_view is = choose(language, place.help_en, place.help_ja);
      std::string value = syntax_of(place);
      value.append(choose(language, ": ", "：")).append(is);
      if (place.is_told() && help.find(value) == std::string::npos) help += "; " + value;
    }
  return help;
}

std::string syntax_of(const OpInfo& op) { return ryosen::syntax_of(op.line); }
const std::string& syntax_of(const CommandRow& row) { return row.syntax; }

// A row of the operators or of the commands.
template <class Row>
void add(Columns& columns, const Row& row, Language language) {
  std::string left(row.id), help(help_of(row, language));
  if (const std::string syntax = syntax_of(row); !syntax.empty()) left.append(" ").append(syntax);
  if (!row.aliases.empty())
    help.append(choose(language, " (also ", "（別名 ")).append(row.aliases).append(choose(language, ")", "）"));
  columns.add(std::move(left), help);
}

std::string solved_by(const AlgorithmRow& row) {
  std::string kinds;
  for (ProblemKind kind : row.solves) kinds += (kinds.empty() ? "" : ", ") + std::string(row_of(kind).id);
  return kinds;
}

}  // namespace

std::string ids_below(const Text& title, Ids ids, Language language) {
  Columns columns;
  for (const IdEntry& row : list_of(ids).entries()) columns.add(row.id, row.text.in(language));
  return title.in(language) + columns.text();
}

std::string problem_kinds_topic(Language language) {
  return ids_below({"Kinds:\n", "種類：\n"}, Ids::problems, language);
}

std::string shot_topic(Language language) {
  Columns columns;
  for (const HighlightRow& row : highlight_table()) {
    std::string help(choose(language, row.legend_en, row.legend_ja));
    if (row.is_shown_at_first()) help.append(choose(language, " (shown at first)", "（初めから表示）"));
    columns.add(std::string(row.id), help);
  }
  return std::string(choose(language, "Highlights for --show:\n", "--show の強調表示：\n")) + columns.text() + "\n" +
         script_commands_topic(language);
}

std::string repairs_topic(Language language) {
  Columns unasked, named;
  for (const AlgorithmRow& row : algorithm_table()) {
    if (!row.is_repair()) continue;
    std::string help(choose(language, row.help_en, row.help_ja));
    for (const ParameterRow& parameter : row.parameters)
      help.append("; ").append(choose(language, parameter.help_en, parameter.help_ja));
    help.append(choose(language, "; solves ", "（対象：")).append(solved_by(row)).append(choose(language, "", "）"));
    (row.keeps_geometry ? unasked : named).add(std::string(row.id) + kinds_syntax(row), help);
  }
  return std::string(choose(
             language, "Done unless --kinds names others (every place and face stays; exact T-junctions are split):\n",
             "--kinds を省いたときに行うもの（形状はすべて保たれ、正確な T 字接合は分割される）：\n")) +
         unasked.text() +
         std::string(choose(language, "Done where --kinds names them:\n", "--kinds で指定したときだけ行うもの：\n")) +
         named.text();
}

std::string algorithm_topic(const AlgorithmRow& row, Language language) {
  const std::string syntax = syntax_of(row.parameters);
  std::string text(choose(language, "In scripts: ", "スクリプトでは："));
  text.append(called(row)).append(syntax.empty() ? "" : " ").append(syntax).append("\n");
  if (row.is_repair()) text.append(choose(language, "Solves: ", "対象：")).append(solved_by(row)).append("\n");
  return text;
}

std::string operators_topic(Language language) {
  Columns columns;
  for (const OpInfo& op : all_ops()) add(columns, op, language);
  return std::string(choose(language, "Operators:\n", "操作：\n")) + columns.text();
}

std::string maps_topic(Language language) { return ids_below({"Maps:\n", "項目：\n"}, Ids::maps, language); }

std::string recovery_topic(Language language) {
  const std::string folder = recovery_folder().string();
  const std::string place = folder.empty() ? "$XDG_STATE_HOME/ryosen/recovery" : folder;
  return std::string(choose(language, "After a crash:\n", "異常終了したとき：\n")) +
         (language == Language::japanese
              ? "  編集は一つごとに、保存されるまで " + place +
                    " のスクリプトに記録されます。\n"
                    "  次にエディタを開くと復元するか尋ねます（ファイルメニューの「復元...」でも開けます）。\n"
                    "  画面なしでは：ryosen edit --new --do \"recover list\"、--do \"recover 1\" -o OUT\n"
                    "  元のファイルが変更されていれば先に知らせます：recover 1 as_was は当時のメッシュに復元し、\n"
                    "  ファイルはそのまま残します。recover 1 as_is は今のファイルに対してやり直します。\n"
              : "  Every edit that is not saved yet is kept in a script in " + place +
                    ", beside a copy of the file.\n"
                    "  The editor offers it at its next start, and under Recover... in the menu File.\n"
                    "  Without a window: ryosen edit --new --do \"recover list\", --do \"recover 1\" -o OUT\n"
                    "  Where the file has changed since, that is said first: recover 1 as_was recovers the mesh as it\n"
                    "  was and leaves the file alone; recover 1 as_is does the edits again on the file "
                    "as it is now.\n");
}

std::string script_commands_topic(Language language) {
  Columns columns;
  for (const CommandRow* row : command_table()) add(columns, *row, language);
  return std::string(choose(language, "Commands, one per line or separated by ; (# begins a comment):\n",
                            "コマンド（一行に一つ、または ; 区切り。# 以降は注釈）：\n")) +
         columns.text();
}

}  // namespace ryosen::cli
