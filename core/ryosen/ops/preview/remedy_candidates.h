// Candidate remedies for one reason of a refusal.
#pragma once

#include <vector>

#include "ryosen/ops/all.h"
#include "ryosen/ops/preview/known_sheets.h"

namespace ryosen {

// Operators near the witnesses, unverified: some may be refused themselves and most will not help. Additions and splits
// come before deletions. At most a few dozen, without `orient`, which affects the whole mesh. Cost: the elements at the
// witnesses, for `lone_edge` worst case all vertices. `sheets` must be a cache for this mesh.
std::vector<AnyOp> remedy_candidates(const Mesh& mesh, const Reason& reason, KnownSheets& sheets);

}  // namespace ryosen
