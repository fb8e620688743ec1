// What repairs change and leave, and why: told of those that were run, and of those that are only tried.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ryosen/algo/repair/recipe.h"

namespace ryosen {

// Repairs as one line asks for them: one of them, run once, or a list, run in rounds.
struct RepairCall {
  std::vector<RecipeStep> steps;
  bool in_rounds = false;
};

struct RepairReport {
  std::size_t changed = 0;          // 0: nothing is written
  Text text;                        // sentences with the numbers
  std::vector<KindCount> findings;  // of the kinds whose number becomes another one
  std::vector<LeftForReason> left;  // what stays, why, and what is for it
  std::optional<Text> fault = {};   // why it cannot be run at all: a clause
  std::size_t problems = 0;         // findings that stay, counted as a list of problems does
  std::size_t others = 0;           // elements among what is left that are none of these
};

// Of a single repair; its findings are not counted. Of the kinds that it is for, all that stays is among what is left.
// O(n log n).
RepairReport report_of(const RepairCall& call, const AlgorithmResult& result, const Mesh& after,
                       const RecipeInput& input);
// Of a list; `after` is the repaired mesh. Kinds that no step is for are among what is left. O(n log n).
RepairReport report_of(const RepairCall& call, const RecipeResult& result, const Mesh& after, const RecipeInput& input);
// Tries it on a mesh that is thrown away; the values are in their ranges on it. None: cancelled. Cost: that of the
// repairs.
std::optional<RepairReport> try_repair(Mesh mesh, const RepairCall& call, const RecipeInput& input,
                                       const Progress::Report& progress);

// All of it in sentences, with up to three elements named for each reason; those that are not on the mesh are left out.
// Of the numbers that change and the reasons why something is left so many are told, at least one of each, the rest is
// counted.
Text told(const RepairReport& report, const Mesh& mesh, std::size_t most = std::string::npos);
// Without what becomes of the findings: "One face was deleted. 5 problems are left. 2 elements stay as they are."
Text in_short(const RepairReport& report);
// The same where its text is one sentence, up to how it was done: "One hole was filled. One problem is left." Where
// nothing changes, for one reason, that: "No change: every patch has a face without area." Else in_numbers().
Text in_one_clause(const RepairReport& report);
// Only how much: "3 changes. 5 problems are left. 2 elements stay as they are."
Text in_numbers(const RepairReport& report);
// "REASON (2: v12, v15)"
Text told(const LeftForReason& left, const Mesh& mesh);

}  // namespace ryosen
