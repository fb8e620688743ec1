// The rows of remeshing in the table of algorithms.
#pragma once

#include <vector>

#include "ryosen/algo/algorithms.h"

namespace ryosen {

std::vector<AlgorithmRow> remeshing_rows();

}  // namespace ryosen
