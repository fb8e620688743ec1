// The rows of remeshing in the table of algorithms.
#pragma once

#include <vector>

#include "ryosen/algo/algorithm.h"

namespace ryosen {

std::vector<AlgorithmRow> remeshing_rows();

}  // namespace ryosen
