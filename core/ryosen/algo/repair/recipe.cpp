#include "ryosen/algo/repair/recipe.h"

#include <algorithm>
#include <string>

#include "ryosen/algo/repair/orient_faces.h"
#include "ryosen/algo/repair/pockets.h"
#include "ryosen/algo/repair/side_effects.h"
#include "ryosen/analysis/problem_sets.h"
#include "ryosen/analysis/problems.h"
#include "ryosen/indexed/to_indexed.h"
#include "ryosen/mesh/circulate.h"

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

struct State {
  Mesh mesh;
  Descent descent;
  bool has_quarantine;
  FindingCounts counts;
};

// Vertices that are gone from the mesh and that writing brings back without a face.
std::size_t kept_by_the_file(const Mesh& mesh, const RecipeInput& input, bool has_quarantine) {
  const std::span<const Vertex> used = has_quarantine ? input.used_elsewhere : input.used_but_by_quarantine;
  const std::vector<Vertex> kept = find_lost(mesh, {}, used).kept;
  return static_cast<std::size_t>(std::count_if(kept.begin(), kept.end(), [&](Vertex v) {
    return !std::binary_search(input.on_lines.begin(), input.on_lines.end(), v);
  }));
}

class RecipeRun {
 public:
  RecipeRun(std::span<const RecipeStep> steps, const RecipeInput& input, const RecipeEvents& events)
      : steps_(steps), input_(input), events_(events), goal_(steps), results_(steps.size()) {}

  // None: cancelled.
  std::optional<RecipeResult> run(const Mesh& mesh) {
    State state{mesh, Descent::for_checks(mesh), !input_.quarantine.empty(), count_findings(mesh, input_.on_lines)};
    RecipeResult result;
    result.steps.resize(steps_.size());
    result.boundary_edges_before = boundary_edges(state);
    for (std::size_t round = 1;; ++round) {
      State next = state;
      if (!run_round(next, round)) return std::nullopt;
      const bool has_changed =
          std::any_of(results_.begin(), results_.end(), [](const AlgorithmResult& r) { return r.changed > 0; });
      const bool is_kept = has_changed && goal_.is_nearer(found_in(next), found_in(state));
      if (round == 1 || is_kept || !has_changed) add_round(result, has_changed && !is_kept);
      if (!is_kept) {
        if (has_changed && events_.round_undone) events_.round_undone(round);
        break;
      }
      ++result.rounds;
      state = std::move(next);
    }
    result.is_changed = result.rounds > 0;
    result.boundary_edges_after = boundary_edges(state);
    result.drops_quarantined = !input_.quarantine.empty() && !state.has_quarantine;
    count_kinds(mesh, input_, true, &KindCount::before, result.findings);
    count_kinds(state.mesh, input_, state.has_quarantine, &KindCount::after, result.findings);
    if (result.is_changed) tell_loose(mesh, state.mesh, result.steps);
    result.mesh = std::move(state.mesh);
    result.descent = std::move(state.descent);
    return result;
  }

 private:
  // Adds the loose pieces of all rounds to what the last changing step left.
  static void tell_loose(const Mesh& before, const Mesh& after, std::vector<AlgorithmResult>& steps) {
    for (AlgorithmResult& step : steps) std::erase_if(step.left_for, tells_of_loose_pieces);
    const auto last =
        std::find_if(steps.rbegin(), steps.rend(), [](const AlgorithmResult& step) { return step.changed > 0; });
    if (last != steps.rend()) add_loose_pieces(components_of(before), after, *last);
  }

  static std::size_t boundary_edges(const State& state) {
    return state.counts[static_cast<std::size_t>(ProblemKind::boundary_loop)];
  }

  bool run_round(State& state, std::size_t round) {
    std::vector<ReadValues> values;
    for (const RecipeStep& step : steps_) values.push_back(step.values.on(state.mesh));
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      const RecipeStep& step = steps_[i];
      results_[i] = {};
      if (!values[i].values) continue;  // of a share that has become none
      Progress progress([&](double share) { return !events_.progress || events_.progress(step, round, share); });
      Journal journal;
      Descent descent = state.descent;
      Edit edit(state.mesh, &journal, &descent);
      const bool has_quarantine = state.has_quarantine;
      const AlgorithmInput input{*values[i].values,
                                 has_quarantine ? input_.used_elsewhere : input_.used_but_by_quarantine,
                                 has_quarantine ? input_.quarantine.size() : 0,
                                 input_.on_lines,
                                 {},
                                 input_.holds_floats};
      results_[i] = run_guarded(edit, *step.row, input, progress, state.counts);
      if (!progress.go_on() || progress.is_cancelled()) return false;
      if (results_[i].changed > 0) {
        edit.commit();
        state.descent = std::move(descent);
      }
      state.has_quarantine = has_quarantine && !results_[i].drops_quarantined;
      if (events_.step_done) events_.step_done(step, round, results_[i]);
    }
    return true;
  }

  FoundInMesh found_in(const State& state) const {
    return {&state.mesh, state.counts, state.has_quarantine ? input_.quarantine.size() : 0};
  }

  void add_round(RecipeResult& result, bool is_undone) const {
    const Text undone{"Undone, since the repairs together take away nothing that they are for.",
                      "修復全体で対象の問題が減らないため、元に戻しました。"};
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      AlgorithmResult& sum = result.steps[i];
      const AlgorithmResult& now = results_[i];
      sum.left = now.left;
      if (!is_undone) sum.left_for = now.left_for;
      if (is_undone) sum.left += now.changed;
      if (is_undone || now.changed == 0) {
        if (sum.changed == 0) sum.text = is_undone && now.changed > 0 ? undone : now.text;
        continue;
      }
      sum.text = sum.changed == 0 ? now.text : sum.text + Text{" ", ""} + now.text;
      sum.changed += now.changed;
      if (now.crossings) sum.crossings = sum.crossings.value_or(0) + *now.crossings;
      sum.drops_quarantined |= now.drops_quarantined;
    }
  }

  std::span<const RecipeStep> steps_;
  const RecipeInput& input_;
  const RecipeEvents& events_;
  RecipeGoal goal_;
  std::vector<AlgorithmResult> results_;  // of the last round
};

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

void count_kinds(const Mesh& mesh, const RecipeInput& input, bool has_quarantine, std::size_t KindCount::*at,
                 std::vector<KindCount>& findings) {
  const ProblemSets sets(mesh, 0, input.on_lines);
  const FileFaces file{has_quarantine ? input.quarantine : std::span<const QuarantinedFace>(), {}, nullptr};
  if (findings.empty())
    for (const ProblemRow& row : problem_table())
      if (!row.is_on_request()) findings.push_back({row.kind});
  for (const Problem& problem : find_problems(mesh, sets, file))
    for (KindCount& entry : findings)
      if (entry.kind == problem.kind) entry.*at = problem.count();
  for (KindCount& entry : findings)
    if (entry.kind == ProblemKind::isolated_vertex) entry.*at += kept_by_the_file(mesh, input, has_quarantine);
}

std::optional<RecipeResult> run_recipe(const Mesh& mesh, std::span<const RecipeStep> steps, const RecipeInput& input,
                                       const RecipeEvents& events) {
  return RecipeRun(steps, input, events).run(mesh);
}

RecipeGoal::RecipeGoal(std::span<const RecipeStep> steps) {
  for (const RecipeStep& step : steps) {
    for (const ProblemKind kind : step.row->solves) is_for_[static_cast<std::size_t>(kind)] = true;
    is_for_orientation_ = is_for_orientation_ || step.row->run == orient_faces;
  }
}

// The second face of each is a duplicate, and that of two triangles closes a hanging pair.
std::size_t RecipeGoal::problems_of_pockets(const FoundInMesh& found) const {
  if (found.counts[static_cast<std::size_t>(ProblemKind::duplicate_face)] == 0) return 0;
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
