// The row of smoothing in the table of algorithms.
#pragma once

#include <vector>

#include "ryosen/algo/algorithm.h"

namespace ryosen {

std::vector<AlgorithmRow> smoothing_rows();

}  // namespace ryosen
