#include "app/cli/contract/id_lists.h"

#include <array>

#include "app/cli/exit_codes.h"
#include "app/cli/subcommand_table.h"
#include "app/editor/commands.h"
#include "core/algo/algorithms.h"
#include "core/analysis/mesh_kind.h"
#include "core/analysis/problem_kinds.h"
#include "core/base/codes.h"
#include "core/base/reasons.h"
#include "core/forms/all.h"
#include "core/forms/pairing.h"
#include "core/highlights/highlight_table.h"
#include "core/io/formats.h"
#include "core/ops/all.h"

namespace ryosen::cli {

namespace {

IdEntry entry(std::string_view id, std::string_view en, std::string_view ja,
              std::vector<std::string_view> severities = {}) {
  return {std::string(id), {std::string(en), std::string(ja)}, std::move(severities)};
}

std::vector<IdEntry> exit_code_entries() {
  std::vector<IdEntry> all;
  for (const ExitCodeText& row : exit_code_texts())
    all.push_back(entry(std::to_string(static_cast<int>(row.code)), row.en, row.ja));
  return all;
}

std::vector<std::string_view> severities_of(const CodeRow& row) {
  switch (row.severity) {
    case CodeSeverity::error:
      return {"error"};
    case CodeSeverity::warning:
      return {"warning"};
    case CodeSeverity::error_or_warning:
      return {"error", "warning"};
    case CodeSeverity::info:
      break;
  }
  return {"info"};
}

std::vector<IdEntry> code_entries() {
  std::vector<IdEntry> all;
  for (const CodeRow& row : code_table()) all.push_back(entry(row.id, row.en, row.ja, severities_of(row)));
  return all;
}

std::vector<IdEntry> rule_entries() {
  std::vector<IdEntry> all;
  for (const RuleText& row : rule_table())
    all.push_back(entry(row.id, row.en, row.ja, {row.severity == RuleSeverity::refuse ? "refuse" : "warn"}));
  return all;
}

std::vector<IdEntry> problem_entries() {
  std::vector<IdEntry> all;
  for (const ProblemRow& row : problem_table())
    all.push_back(
        entry(row.id, row.name_en, row.name_ja, {row.severity == ProblemSeverity::problem ? "problem" : "info"}));
  return all;
}

std::vector<IdEntry> highlight_entries() {
  std::vector<IdEntry> all;
  for (const HighlightRow& row : highlight_table()) all.push_back(entry(row.id, row.name_en, row.name_ja));
  return all;
}

std::vector<IdEntry> operator_entries() {
  std::vector<IdEntry> all;
  for (const OpInfo& row : all_ops()) all.push_back(entry(row.id, row.help_en, row.help_ja));
  return all;
}

std::vector<IdEntry> command_entries() {
  std::vector<IdEntry> all;
  for (const CommandRow& row : command_table())
    if (!find_op(row.id)) all.push_back(entry(row.id, row.help_en, row.help_ja));
  return all;
}

std::vector<IdEntry> repair_entries() {
  std::vector<IdEntry> all;
  for (const AlgorithmRow& row : algorithm_table())
    if (row.is_repair()) all.push_back(entry(row.id, row.help_en, row.help_ja));
  return all;
}

std::vector<IdEntry> algorithm_entries() {
  std::vector<IdEntry> all;
  for (const AlgorithmRow& row : algorithm_table()) all.push_back(entry(row.id, row.help_en, row.help_ja));
  return all;
}

std::vector<IdEntry> mesh_kind_entries() {
  std::vector<IdEntry> all;
  for (const MeshKindRow& row : mesh_kind_table()) all.push_back(entry(row.id, row.name_en, row.name_ja));
  return all;
}

std::vector<IdEntry> format_entries() {
  std::vector<IdEntry> all;
  for (const Format& row : formats()) all.push_back(entry(row.id, row.name.en, row.name.ja));
  return all;
}

std::vector<IdEntry> form_entries() {
  std::vector<IdEntry> all;
  for (const forms::FormRow& row : forms::all_forms()) all.push_back(entry(row.id, row.en, row.ja));
  return all;
}

std::vector<IdEntry> relation_entries() {
  std::vector<IdEntry> all;
  for (const forms::RelationRow& row : forms::relations()) all.push_back(entry(row.id, row.en, row.ja));
  return all;
}

std::vector<IdEntry> pairing_entries() {
  std::vector<IdEntry> all;
  for (const PairingMethod& row : pairing_methods()) all.push_back(entry(row.id, row.en, row.ja));
  return all;
}

std::vector<IdEntry> subcommand_entries() {
  std::vector<IdEntry> all;
  for (const Subcommand& row : subcommands()) all.push_back(entry(row.id, row.en, row.ja));
  return all;
}

constexpr std::array lists{
    IdList{Ids::exit_codes, "exit_codes", "Exit codes", "終了コード", exit_code_entries},
    IdList{Ids::codes, "codes", "Codes of messages", "メッセージのコード", code_entries},
    IdList{Ids::rules, "rules", "Rules: why an operator is refused or warned about", "操作の拒否・警告の規則",
           rule_entries},
    IdList{Ids::problems, "problems", "Kinds of problems", "問題の種類", problem_entries},
    IdList{Ids::highlights, "highlights", "Highlights", "強調表示", highlight_entries},
    IdList{Ids::operators, "operators", "Operators", "操作", operator_entries},
    IdList{Ids::commands, "commands", "Commands of scripts besides operators", "操作以外のスクリプトのコマンド",
           command_entries},
    IdList{Ids::repairs, "repairs", "Repairs", "修復", repair_entries},
    IdList{Ids::algorithms, "algorithms", "Algorithms", "アルゴリズム", algorithm_entries},
    IdList{Ids::mesh_kinds, "mesh_kinds", "What a mesh is", "メッシュの種類", mesh_kind_entries},
    IdList{Ids::formats, "formats", "File formats", "ファイル形式", format_entries},
    IdList{Ids::forms, "forms", "Representations of the source texts", "テキストの形状表現", form_entries},
    IdList{Ids::relations, "relations", "Queries of elements around an element", "隣接要素の問い合わせ",
           relation_entries},
    IdList{Ids::pairings, "pairings", "Ways to pair the halfedges", "半稜線の対を見つける方法", pairing_entries},
    IdList{Ids::subcommands, "subcommands", "Commands of the program", "プログラムのコマンド", subcommand_entries},
};

constexpr bool lists_are_in_order() {
  for (std::size_t i = 0; i < lists.size(); ++i)
    if (static_cast<std::size_t>(lists[i].ids) != i + 1) return false;
  return lists.size() == static_cast<std::size_t>(Ids::subcommands);
}
static_assert(lists_are_in_order(), "the table has one row per list, in the order of the enumeration");

}  // namespace

std::span<const IdList> id_lists() { return lists; }

const IdList& list_of(Ids ids) { return lists[static_cast<std::size_t>(ids) - 1]; }

}  // namespace ryosen::cli
