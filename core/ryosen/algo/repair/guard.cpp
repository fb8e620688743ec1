#include "ryosen/algo/repair/guard.h"

#include <string>

#include "ryosen/algo/repair/side_effects.h"
#include "ryosen/algo/repair/pockets.h"
#include "ryosen/analysis/problem_sets.h"

namespace ryosen {

namespace {

AlgorithmResult refusal(const AlgorithmRow& row, const AlgorithmResult& wanted, const ProblemRow& kind,
                        std::size_t more) {
  AlgorithmResult result;
  result.left = wanted.changed + wanted.left;
  const std::string n = std::to_string(more), id(row.id);
  result.text = {
      "Nothing was changed: " + id + " would add " + n + " of the kind " + std::string(kind.id) + ".",
      "変更していません（" + id + " を行うと「" + std::string(kind.name_ja) + "」が " + n + " 増えるため）。"};
  return result;
}

}  // namespace

FindingCounts count_findings(const Mesh& mesh, std::span<const Vertex> on_lines) {
  const ProblemSets sets(mesh, 0, on_lines);
  FindingCounts counts{};
  for (const ProblemRow& row : problem_table()) counts[static_cast<std::size_t>(row.kind)] = sets.count(row.kind);
  return counts;
}

bool must_not_grow(const ProblemRow& row) {
  return row.severity == ProblemSeverity::problem && row.is_local() && !row.is_of_the_vertex &&
         row.kind != ProblemKind::hanging_pair;
}

AlgorithmResult run_guarded(Edit& edit, const AlgorithmRow& row, const AlgorithmInput& input, Progress& progress,
                            FindingCounts& counts) {
  FaceComponents components;
  std::size_t pockets = 0;
  if (row.is_repair()) {
    components = components_of(edit.mesh());
    pockets = pockets_of(edit.mesh()).size();
  }
  AlgorithmResult result = row.run(edit, input, progress);
  if (!row.is_repair() || progress.is_cancelled() || result.changed == 0) return result;
  const FindingCounts after = count_findings(edit.mesh(), input.on_lines);
  for (const ProblemRow& kind : problem_table()) {
    const auto k = static_cast<std::size_t>(kind.kind);
    if (!must_not_grow(kind) || after[k] <= counts[k]) continue;
    const std::size_t more = after[k] - counts[k];
    if (kind.kind == ProblemKind::duplicate_face && pockets + more <= pockets_of(edit.mesh()).size()) continue;
    return refusal(row, result, kind, more);
  }
  counts = after;
  add_loose_pieces(components, edit.mesh(), result);
  return result;
}

}  // namespace ryosen
