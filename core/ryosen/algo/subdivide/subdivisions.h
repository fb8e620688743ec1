// The rows of subdivision in the table of algorithms.
#pragma once

#include <vector>

#include "ryosen/algo/algorithm.h"

namespace ryosen {

std::vector<AlgorithmRow> subdivision_rows();

}  // namespace ryosen
