// How far a question about an edge goes.
#pragma once

#include <cstddef>

#include "ryosen/ops/all.h"

namespace ryosen {

// Whether a face or hole at the edge of the operator has more than `most` sides or, for a collapse, more edges than
// that meet at one of its ends, over all copies. False for operators on other elements. O(most).
bool reaches_further(const Mesh& mesh, const AnyOp& op, std::size_t most);

}  // namespace ryosen
