// The rows of what adds copies of elements: duplicates, and mirror images.
#pragma once

#include <vector>

#include "ryosen/algo/algorithm.h"

namespace ryosen {

std::vector<AlgorithmRow> copying_rows();

}  // namespace ryosen
