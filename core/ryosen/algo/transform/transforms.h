// The rows of the transforms: algorithms that move points and leave the rest as it is.
#pragma once

#include <vector>

#include "ryosen/algo/algorithm.h"

namespace ryosen {

std::vector<AlgorithmRow> transform_rows();

}  // namespace ryosen
