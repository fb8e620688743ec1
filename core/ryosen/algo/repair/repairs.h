// The rows of the repairs: algorithms that take whole kinds of problems away at once. Each has a pair of files of its
// own.
#pragma once

#include <string_view>
#include <vector>

#include "ryosen/algo/algorithm.h"

namespace ryosen {

const std::vector<AlgorithmRow>& repair_rows();

}  // namespace ryosen
