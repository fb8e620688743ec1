// The rows of what adds copies of elements: duplicates, and mirror images.
#pragma once

#include <vector>

#include "ryosen/algo/algorithm.h"

namespace ryosen {

std::vector<AlgorithmRow> duplicate_rows();

}  // namespace ryosen
