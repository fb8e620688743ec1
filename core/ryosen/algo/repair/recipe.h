// Runs repairs: a single one, guarded, with the promise that it adds no finding of a kind that says the surface is
// unsound; or a recipe, repairs with their values, in rounds until nothing changes.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "ryosen/algo/algorithm.h"

namespace ryosen {

// Elements in the mesh by kind, as ProblemSets counts them (of boundary loops their edges); 0 for kinds of the file.
using FindingCounts = std::array<std::size_t, most_problem_kinds>;

// O(corners), and a logarithm beside copies. `on_lines` as for ProblemSets.
FindingCounts count_findings(const Mesh& mesh, std::span<const Vertex> on_lines = {});

// Whether no repair may add to the kind: non-manifold and misoriented edges, non-manifold vertices, duplicates and
// faces without area. Boundary loops and isolated vertices may become more; so may hanging pairs among the duplicates,
// where other faces come off their edges; and duplicates by the pockets that close (pockets.h).
bool must_not_grow(const ProblemRow& row);

// Runs an algorithm. A repair that nevertheless adds to such a kind has `changed` 0, and in `left` what it changed: the
// edit is then not to be committed, as after any algorithm that changes nothing. `counts` are those of the mesh, and
// afterwards those of the mesh if it is committed. Cost: that of the algorithm, and O(n log n) for the counts.
AlgorithmResult run_guarded(Edit& edit, const AlgorithmRow& row, const AlgorithmInput& input, Progress& progress,
                            FindingCounts& counts);

struct RecipeStep {
  const AlgorithmRow* row;  // a repair
  ParameterValues values;   // which are in their ranges on the mesh; shares of the diagonal may be among them
};

// What lies beside the mesh in its file. Views.
struct RecipeInput {
  std::span<const QuarantinedFace> quarantine = {};
  std::span<const Vertex> used_elsewhere = {};          // as for AlgorithmInput
  std::span<const Vertex> used_but_by_quarantine = {};  // the same once the quarantined faces are dropped
  std::span<const Vertex> on_lines = {};                // as for ProblemSets
  std::optional<bool> holds_floats = {};                // as for AlgorithmInput
};

// Each may be empty.
struct RecipeEvents {
  // How far a step is, 0..1; false cancels. Rounds are counted from 1.
  std::function<bool(const RecipeStep&, std::size_t round, double share)> progress = {};
  // A step is done. Its round may still be undone.
  std::function<void(const RecipeStep&, std::size_t round, const AlgorithmResult&)> step_done = {};
  std::function<void(std::size_t round)> round_undone = {};
};

struct KindCount {
  ProblemKind kind;
  std::size_t before = 0, after = 0;  // findings as reports count them: of boundary edges their loops
};

// What is found of every kind unasked, put into `at` of its entry; makes the entries where there are none.
// `has_quarantine`: the quarantined faces have not been dropped. O(n log n).
void count_kinds(const Mesh& mesh, const RecipeInput& input, bool has_quarantine, std::size_t KindCount::*at,
                 std::vector<KindCount>& findings);

struct RecipeResult {
  Mesh mesh;                           // the repaired one
  Descent descent;                     // from the mesh before, in test builds
  bool is_changed = false;             // whether anything differs
  bool drops_quarantined = false;      // the quarantined faces are to be forgotten
  std::size_t rounds = 0;              // that changed something and were kept
  std::vector<AlgorithmResult> steps;  // by step, over the rounds that were kept; `left` and a text of nothing done
                                       // are those of the last
  std::vector<KindCount> findings;     // every kind that is found unasked, in the order of the table
  std::size_t boundary_edges_before = 0, boundary_edges_after = 0;
};

// Runs the steps in their order, again and again until a round changes nothing. A round takes shares of the diagonal
// from the mesh with which it begins. It is undone, and ends the recipe, unless it comes nearer to what the steps are
// for (RecipeGoal): it lowers the number of problems of their kinds; or keeps it and lowers the number of boundary
// edges where boundary loops are among these; or keeps both and lowers the number of faces that look inwards where
// `orient` is a step. So every recipe ends, and repeating it on its result changes nothing. Each step runs guarded.
// None if it was cancelled. The mesh is not touched. Cost: that of the steps and a copy of the mesh per round;
// a recipe has few rounds, at most one per finding.
std::optional<RecipeResult> run_recipe(const Mesh& mesh, std::span<const RecipeStep> steps, const RecipeInput& input,
                                       const RecipeEvents& events = {});

// Findings of a mesh, which must outlive them.
struct FoundInMesh {
  const Mesh* mesh;
  FindingCounts counts;
  std::size_t quarantined;  // faces
};

// First the number of problems of the kinds in the steps' `solves`, but for those of pockets (pockets.h), which no
// repair takes away; then that of boundary edges where boundary loops are among them (edges, since welding may make two
// loops of one: a strip closed to a band); then, where `orient` is a step, that of faces that look inwards
// (count_turned_wrong).
class RecipeGoal {
 public:
  explicit RecipeGoal(std::span<const RecipeStep> steps);

  // O(n), unless only what looks inwards tells them apart.
  bool is_nearer(const FoundInMesh& now, const FoundInMesh& before) const;

 private:
  std::pair<std::size_t, std::size_t> measure(const FoundInMesh& found) const;
  std::size_t problems_of_pockets(const FoundInMesh& found) const;
  bool is_for(ProblemKind kind) const { return is_for_[static_cast<std::size_t>(kind)]; }

  std::array<bool, most_problem_kinds> is_for_{};
  bool is_for_orientation_ = false;
};

}  // namespace ryosen
