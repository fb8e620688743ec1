#include "app/cli/help_topics.h"

#include <string_view>

#include "app/cli/columns.h"
#include "app/editor/commands.h"
#include "app/editor/recovery.h"
#include "core/algo/repair/repairs.h"
#include "core/analysis/problem_kinds.h"
#include "core/forms/all.h"
#include "core/forms/pairing.h"
#include "core/highlights/highlight_table.h"

namespace ryosen::cli {

namespace {

std::string_view choose(Language language, std::string_view en, std::string_view ja) {
  return language == Language::japanese ? ja : en;
}

void add(Columns& columns, std::string_view id, std::string_view syntax, std::string_view help) {
  std::string left(id);
  if (!syntax.empty()) left.append(" ").append(syntax);
  columns.add(std::move(left), help);
}

void add_operators(Columns& columns, Language language) {
  for (const OpInfo& op : all_ops()) {
    std::string help(choose(language, op.help_en, op.help_ja));
    if (!op.aliases.empty())
      help.append(choose(language, " (also ", "（別名 ")).append(op.aliases).append(choose(language, ")", "）"));
    add(columns, op.id, op.syntax, help);
  }
}

}  // namespace

std::string problem_kinds_topic(Language language) {
  Columns columns;
  for (const ProblemRow& row : problem_table())
    columns.add(std::string(row.id), choose(language, row.name_en, row.name_ja));
  return std::string(choose(language, "Kinds:\n", "種類：\n")) + columns.text();
}

std::string shot_topic(Language language) {
  Columns columns;
  for (const HighlightRow& row : highlight_table()) {
    std::string help(choose(language, row.legend_en, row.legend_ja));
    if (row.shown_at_first == ShownAtFirst::yes) help.append(choose(language, " (shown at first)", "（初めから表示）"));
    columns.add(std::string(row.id), help);
  }
  return std::string(choose(language, "Highlights for --show:\n", "--show の強調表示：\n")) + columns.text() + "\n" +
         script_commands_topic(language);
}

std::string repairs_topic(Language language) {
  Columns unasked, named;
  for (const RepairRow& row : repair_table()) {
    std::string solves;
    for (ProblemKind kind : row.solves) solves += (solves.empty() ? "" : ", ") + std::string(row_of(kind).id);
    std::string help(choose(language, row.help_en, row.help_ja));
    help.append(choose(language, "; solves ", "（対象：")).append(solves).append(choose(language, "", "）"));
    const std::string syntax = row.syntax.empty() ? "" : "=" + std::string(row.syntax);
    (row.keeps_geometry ? unasked : named).add(std::string(row.id) + syntax, help);
  }
  return std::string(choose(language, "Done unless --kinds names others (every place and face stays):\n",
                            "--kinds を省いたときに行うもの（形状はすべて保たれる）：\n")) +
         unasked.text() +
         std::string(choose(language, "Done where --kinds names them:\n", "--kinds で指定したときだけ行うもの：\n")) +
         named.text();
}

std::string operators_topic(Language language) {
  Columns columns;
  add_operators(columns, language);
  return std::string(choose(language, "Operators:\n", "操作：\n")) + columns.text();
}

std::string forms_topic(Language language) {
  Columns rows, methods;
  for (const forms::FormRow& row : forms::all_forms())
    rows.add(std::string(row.id), std::string(choose(language, row.en, row.ja)) + " (" +
                                      std::string(choose(language, row.source_en, row.source_ja)) + ")");
  for (const PairingMethod& method : pairing_methods())
    methods.add(std::string(method.id), choose(language, method.en, method.ja));
  return std::string(choose(language, "Forms:\n", "形状表現：\n")) + rows.text() +
         std::string(choose(language, "Ways to pair the halfedges:\n", "半稜線の対を見つける方法：\n")) +
         methods.text();
}

std::string recovery_topic(Language language) {
  const std::string folder = recovery_folder().string();
  const std::string place = folder.empty() ? "$XDG_STATE_HOME/ryosen/recovery" : folder;
  return std::string(choose(language, "After a crash:\n", "異常終了したとき：\n")) +
         (language == Language::japanese
              ? "  編集は一つごとに、保存されるまで " + place +
                    " のスクリプトに記録されます。\n"
                    "  次にエディタを開くと復元するか尋ねます（ファイルメニューの「復元...」でも開けます）。\n"
                    "  画面なしでは：ryosen edit --new --do \"recover list\"、--do \"recover 1\" -o OUT\n"
              : "  Every edit that is not saved yet is kept in a script in " + place +
                    ".\n"
                    "  The editor offers it at its next start, and under Recover... in the menu File.\n"
                    "  Without a window: ryosen edit --new --do \"recover list\", --do \"recover 1\" -o OUT\n");
}

std::string script_commands_topic(Language language) {
  Columns columns;
  add_operators(columns, language);
  for (const CommandRow& row : command_table())
    add(columns, row.id, row.syntax, choose(language, row.help_en, row.help_ja));
  return std::string(choose(language, "Commands, one per line or separated by ; (# begins a comment):\n",
                            "コマンド（一行に一つ、または ; 区切り。# 以降は注釈）：\n")) +
         columns.text();
}

}  // namespace ryosen::cli
