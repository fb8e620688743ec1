// The lines that call algorithms and select, as a script has them.
#pragma once

#include <string>
#include <string_view>

#include "ryosen/algo/algorithm.h"
#include "ryosen/analysis/problem_kinds.h"
#include "ryosen/scene/selection/selectors.h"

namespace ryosen {

// How scripts call an algorithm: by its id, behind `repair` where that is wanted or an operator has the id.
std::string called(const AlgorithmRow& algorithm, bool as_repair = false);
// The line that selects what a row of the table of selectors finds, with its usual value.
std::string select_line(const Selector& row);
// Before the id of a problem, which a selector may have too.
inline constexpr std::string_view of_problem = "problem";
// The line that selects all that has a problem, or what the one at an element is about; never that of a selector.
std::string select_line(const ProblemRow& row, std::string_view element = {});

}  // namespace ryosen
