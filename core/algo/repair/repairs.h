// The rows of the repairs: algorithms that take whole kinds of problems away at once. Each has a pair of files of its own.
#pragma once

#include <string_view>
#include <vector>

#include "core/algo/algorithms.h"

namespace ryosen {

std::vector<AlgorithmRow> repair_rows();

// "{done}; {left} ..." put together from a count and a noun with its verb: sentences of the repairs.
Text repair_text(std::size_t changed, std::string_view en_one, std::string_view en_many, std::string_view ja);

}  // namespace ryosen
