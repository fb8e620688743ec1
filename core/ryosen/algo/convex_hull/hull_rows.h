// The row of the convex hull: it is added beside what it is the hull of.
#pragma once

#include <vector>

#include "ryosen/algo/algorithm.h"

namespace ryosen {

std::vector<AlgorithmRow> hull_rows();

}  // namespace ryosen
