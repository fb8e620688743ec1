// The row of the random points: a primitive of points alone.
#pragma once

#include <vector>

#include "ryosen/algo/algorithm.h"

namespace ryosen {

std::vector<AlgorithmRow> point_cloud_rows();

}  // namespace ryosen
