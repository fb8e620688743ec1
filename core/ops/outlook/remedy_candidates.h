// What may help against one reason for a refusal.
#pragma once

#include <vector>

#include "core/ops/all.h"
#include "core/ops/outlook/known_sheets.h"

namespace ryosen {

// Operators near the witnesses, untried: some may be refused themselves and most will not help. What adds or cuts comes
// before what takes away. At most a few dozen, without `orient`, which concerns the whole mesh. Cost: the elements at
// the witnesses, for `lone_edge` at worst the vertices of the mesh. `sheets` must know nothing of another mesh.
std::vector<AnyOp> remedy_candidates(const Mesh& mesh, const Reason& reason, KnownSheets& sheets);

}  // namespace ryosen
