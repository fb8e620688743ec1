// What would make a refused operator legal.
#pragma once

#include <string>
#include <vector>

#include "core/ops/all.h"

namespace ryosen {

// Script lines after which the operator is legal, in order; empty when no sequence of local remedies was found
// ("never"). Every answer has been tried in an Edit that rolled back, so it holds. The mesh is byte-equal afterwards.
// Cost: a few operators per reason.
std::vector<std::string> find_remedy(Mesh& mesh, const AnyOp& op);

}  // namespace ryosen
