#include "ryosen/algo/repair/recipe_goal.h"

#include <algorithm>

#include "ryosen/algo/repair/orient_faces.h"
#include "ryosen/algo/repair/pockets.h"
#include "ryosen/mesh/circulate.h"

namespace ryosen {

RecipeGoal::RecipeGoal(std::span<const RecipeStep> steps) {
  for (const RecipeStep& step : steps) {
    for (const ProblemKind kind : step.row->solves) is_for_[static_cast<std::size_t>(kind)] = true;
    is_for_orientation_ = is_for_orientation_ || step.row->run == orient_faces;
  }
}

// The second face of each is a duplicate, and that of two triangles closes a hanging pair.
std::size_t RecipeGoal::problems_of_pockets(const FoundInMesh& found) const {
  const bool may_have_any = found.counts[static_cast<std::size_t>(ProblemKind::duplicate_face)] > 0;
  if (!may_have_any) return 0;
  std::size_t problems = 0;
  for (const auto& [first, second] : pockets_of(*found.mesh)) {
    problems += is_for(ProblemKind::duplicate_face);
    problems += is_for(ProblemKind::hanging_pair) && corner_count(*found.mesh, second) == 3;
  }
  return problems;
}

std::pair<std::size_t, std::size_t> RecipeGoal::measure(const FoundInMesh& found) const {
  std::size_t problems = 0;
  for (const ProblemRow& row : problem_table()) {
    if (!is_for(row.kind) || row.severity != ProblemSeverity::problem) continue;
    if (!row.quarantined)
      problems += found.counts[static_cast<std::size_t>(row.kind)];
    else if (row.kind == ProblemKind::quarantined_face)
      problems += found.quarantined;
  }
  const std::size_t edges = found.counts[static_cast<std::size_t>(ProblemKind::boundary_loop)];
  problems -= std::min(problems, problems_of_pockets(found));
  return {problems, is_for(ProblemKind::boundary_loop) ? edges : 0};
}

bool RecipeGoal::is_nearer(const FoundInMesh& now, const FoundInMesh& before) const {
  const auto is = measure(now), was = measure(before);
  if (is != was || !is_for_orientation_) return is < was;
  Progress unheard;
  return count_turned_wrong(*now.mesh, unheard) < count_turned_wrong(*before.mesh, unheard);
}

}  // namespace ryosen
