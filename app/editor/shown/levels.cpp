#include "app/editor/shown/levels.h"

#include <utility>

#include "app/editor/commands/text/outcomes.h"
#include "app/editor/document/findings.h"
#include "app/editor/session/frontend.h"
#include "app/editor/shown/shown.h"
#include "ryosen/algo/algorithm_table.h"
#include "ryosen/document/document.h"

namespace ryosen {

std::span<const ParameterRow> level_parameters() {
  static const std::vector<ParameterRow> rows = [] {
    std::vector<ParameterRow> some;
    for (ParameterRow row : find_algorithm("simplify")->parameters) {
      if (row.id == "faces" || row.id == "ratio" || row.id == "force" || row.id == "topology" || row.id == "effort")
        continue;
      row.one_of = "";
      some.push_back(std::move(row));
    }
    return some;
  }();
  return rows;
}

ShownLevels::ShownLevels(std::unique_ptr<DetailLevels> levels, ParameterValues values, const Document& document)
    : levels_(std::move(levels)), values_(std::move(values)), quarantined_(document.tables().quarantine.size()) {}

std::size_t ShownLevels::level_of(std::size_t faces) const {
  return levels_->level_of(faces - std::min(faces, quarantined_));
}

std::string ShownLevels::line() const {
  ParameterValues values = values_;
  values.set("faces", std::to_string(faces()), "faces");
  values.set("force", "on", "force");  // the level was seen
  values.set("effort", "0", "effort");
  return "simplify " + values.line();
}

Outcome leave_level(Shown& shown) {
  shown.end_levels();
  return done_with({"The levels of detail are left; the mesh is as it was before them.",
                    "詳細度の表示を終え、元のメッシュに戻しました。"});
}

std::string line_to_account_for(const Document& document, const Shown& shown) {
  if (shown.shows(ShownBy::level)) return shown.levels()->line();
  if (document.is_on_trial() || document.position() == 0) return {};
  const std::string& line = document.history()[document.position() - 1].command;
  const AlgorithmRow* const row = find_algorithm(line.substr(0, line.find(' ')));
  return row && row->accounts_for_edges ? line : std::string();
}

const LeftEdges* find_left_edges(Document& document, Findings& findings, const Shown& shown, const Frontend& frontend) {
  if (findings.left_edges()) return findings.left_edges();
  const std::string line = line_to_account_for(document, shown);
  if (line.empty()) return nullptr;
  const std::vector<std::string_view> words = split_words(line);
  const AlgorithmRow& row = *find_algorithm(words[0]);
  const ReadValues given = read_values(row.parameters, std::span(words).subspan(1));
  if (!given.values) return nullptr;
  auto result = document.goal_report_of(row, *given.values, frontend.on_progress);
  if (!result || !result->goal_report || result->goal_report->rules.empty()) return nullptr;
  findings.keep_left_edges({document.serial(), document.revision(), std::move(result->goal_report->rules),
                            std::move(result->goal_report->remaining)});
  return findings.left_edges();
}

}  // namespace ryosen
