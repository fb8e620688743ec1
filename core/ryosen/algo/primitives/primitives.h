// The rows of the primitives: algorithms that add a shape of a few numbers as a component of its own. Up is +Y, as the
// camera has it; `at` is the middle of each shape.
#pragma once

#include <vector>

#include "ryosen/algo/algorithm.h"

namespace ryosen {

std::vector<AlgorithmRow> primitive_rows();

}  // namespace ryosen
