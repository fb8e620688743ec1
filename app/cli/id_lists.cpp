#include "app/cli/id_lists.h"

#include <array>

#include "app/cli/subcommand_table.h"
#include "app/editor/commands/commands.h"
#include "ryosen/algo/algorithm_table.h"
#include "ryosen/algo/edge_rules.h"
#include "ryosen/analysis/mesh_kind.h"
#include "ryosen/analysis/problem_kinds.h"
#include "ryosen/base/codes.h"
#include "ryosen/base/enum_table.h"
#include "ryosen/base/reasons.h"
#include "ryosen/io/formats.h"
#include "ryosen/ops/all.h"
#include "ryosen/ops/parameters/op_line.h"
#include "ryosen/scene/highlights/colour_maps.h"
#include "ryosen/scene/highlights/highlight_table.h"

namespace ryosen::cli {

namespace {

using Severities = std::vector<std::string_view>;

Severities severities_of(const CodeRow& row) {
  if (row.severity == CodeSeverity::error_or_warning) return {"error", "warning"};
  if (row.severity == CodeSeverity::error) return {"error"};
  return {row.severity == CodeSeverity::warning ? "warning" : "info"};
}

Severities severities_of(const RuleText& row) { return {row.severity == RuleSeverity::refuse ? "refuse" : "warn"}; }
Severities severities_of(const ProblemRow& row) {
  return {row.severity == ProblemSeverity::problem ? "problem" : "info"};
}
template <class Row>
Severities severities_of(const Row&) {
  return {};
}

bool is_no_operator(const CommandRow& row) { return !find_op(row.id); }
bool is_repair(const AlgorithmRow& row) { return row.is_repair(); }

template <class Row>
const Row& row_at(const Row& row) {
  return row;
}
const CommandRow& row_at(const CommandRow* row) { return *row; }

// Of a table whose rows have an id and these two members.
template <auto table, auto en, auto ja, auto is_wanted = nullptr>
std::vector<IdEntry> entries_of() {
  std::vector<IdEntry> all;
  for (const auto& at : table()) {
    const auto& row = row_at(at);
    if constexpr (!std::is_null_pointer_v<decltype(is_wanted)>)
      if (!is_wanted(row)) continue;
    IdEntry& entry = all.emplace_back(
        IdEntry{std::string(row.id), {std::string(row.*en), std::string(row.*ja)}, severities_of(row)});
    if constexpr (requires { syntax_of(row.line); }) {
      entry.syntax = syntax_of(row.line);
      entry.line = &row.line;
    } else if constexpr (requires { row.syntax; }) {
      entry.syntax = std::string(row.syntax);
    }
  }
  return all;
}

struct ExitCodeText {
  ExitCode code;
  std::string_view en, ja;
};

constexpr ExitCodeText exit_code_rows[] = {
    {ExitCode::done, "done, nothing found", "完了、問題なし"},
    {ExitCode::found_problems, "done; problems, differences or warnings about the file found, or a failed expect",
     "完了、問題・差異・ファイルへの警告あり、または expect の不一致"},
    {ExitCode::usage, "usage, a line that does not parse, an element that never existed",
     "使い方の誤り、解釈できない行、存在したことのない要素"},
    {ExitCode::input_missing, "input missing or unreadable", "入力がない、または読めない"},
    {ExitCode::input_malformed, "input malformed", "入力の内容が不正"},
    {ExitCode::output_not_writable, "output not writable", "出力を書き込めない"},
    {ExitCode::refused, "operation refused", "操作を実行できない"},
    {ExitCode::no_backend, "no display or no render backend", "画面または描画バックエンドがない"},
    {ExitCode::cancelled, "cancelled", "中止された"},
    {ExitCode::some_inputs_failed, "some of several inputs failed", "複数の入力の一部が失敗"},
    {ExitCode::out_of_memory, "not enough memory", "メモリが足りない"},
    {ExitCode::internal_error, "internal error", "内部エラー"},
};

std::vector<IdEntry> exit_code_entries() {
  std::vector<IdEntry> all;
  for (const ExitCodeText& row : exit_code_rows)
    all.push_back({std::to_string(static_cast<int>(row.code)), {std::string(row.en), std::string(row.ja)}, {}});
  return all;
}

std::vector<IdEntry> format_entries() {
  std::vector<IdEntry> all;
  for (const Format& row : formats()) all.push_back({std::string(row.id), row.name, {}});
  return all;
}

constexpr std::array lists{
    IdList{Ids::exit_codes, "exit_codes", "Exit codes", "終了コード", exit_code_entries},
    IdList{Ids::codes, "codes", "Codes of messages", "メッセージのコード",
           entries_of<code_table, &CodeRow::en, &CodeRow::ja>},
    IdList{Ids::rules, "rules", "Rules: why an operator is refused or warned about", "操作の拒否・警告の規則",
           entries_of<rule_table, &RuleText::en, &RuleText::ja>},
    IdList{Ids::problems, "problems", "Kinds of problems", "問題の種類",
           entries_of<problem_table, &ProblemRow::name_en, &ProblemRow::name_ja>},
    IdList{Ids::highlights, "highlights", "Highlights", "強調表示",
           entries_of<highlight_table, &HighlightRow::name_en, &HighlightRow::name_ja>},
    IdList{Ids::operators, "operators", "Operators", "操作", entries_of<all_ops, &OpInfo::help_en, &OpInfo::help_ja>},
    IdList{Ids::commands, "commands", "Commands of scripts besides operators", "操作以外のスクリプトのコマンド",
           entries_of<command_table, &CommandRow::help_en, &CommandRow::help_ja, is_no_operator>},
    IdList{Ids::repairs, "repairs", "Repairs", "修復",
           entries_of<algorithm_table, &AlgorithmRow::help_en, &AlgorithmRow::help_ja, is_repair>},
    IdList{Ids::algorithms, "algorithms", "Algorithms", "アルゴリズム",
           entries_of<algorithm_table, &AlgorithmRow::help_en, &AlgorithmRow::help_ja>},
    IdList{Ids::mesh_kinds, "mesh_kinds", "What a mesh is", "メッシュの種類",
           entries_of<mesh_kind_table, &MeshKindRow::name_en, &MeshKindRow::name_ja>},
    IdList{Ids::formats, "formats", "File formats", "ファイル形式", format_entries},
    IdList{Ids::forms, "forms", "Representations of the source texts", "テキストの形状表現", form_entries},
    IdList{Ids::maps, "maps", "Numbers of elements", "要素ごとの値",
           entries_of<colour_maps, &ColourMap::legend_en, &ColourMap::legend_ja>},
    IdList{Ids::relations, "relations", "Queries of elements around an element", "隣接要素の問い合わせ",
           relation_entries},
    IdList{Ids::pairings, "pairings", "Ways to pair the halfedges", "半稜線の対を見つける方法", pairing_entries},
    IdList{Ids::subcommands, "subcommands", "Commands of the program", "プログラムのコマンド",
           entries_of<subcommands, &Subcommand::en, &Subcommand::ja>},
    IdList{Ids::edge_rules, "edge_rules", "Why an algorithm left an edge", "アルゴリズムが稜線を残した理由",
           entries_of<edge_rule_table, &EdgeRuleRow::en, &EdgeRuleRow::ja>},
    IdList{Ids::steps, "steps", "What is played step by step", "一手ずつ再生できるもの", steps_entries},
    IdList{Ids::roles, "roles", "Parts that elements take in a step", "手順での要素の役割", role_entries},
};

static_assert(rows_are_in_order(lists, &IdList::ids));

}  // namespace

std::span<const IdList> id_lists() { return lists; }

const IdList& list_of(Ids ids) { return lists[static_cast<std::size_t>(ids)]; }

}  // namespace ryosen::cli
