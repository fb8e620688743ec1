// The goal of a list of repairs, and whether a round came nearer to it.
#pragma once

#include <array>
#include <utility>

#include "ryosen/algo/repair/guard.h"
#include "ryosen/algo/repair/recipe.h"

namespace ryosen {

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
