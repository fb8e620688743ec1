// What may help against one reason for a refusal.
#pragma once

#include <vector>

#include "core/ops/all.h"

namespace ryosen {

// Which sheets of a mesh are too large to be tried: those from whose faces a search has come to very many others. What is
// found out is kept, so ask one again while the mesh stays as it is.
class LargeSheets {
 public:
  // Cost: the faces of the sheet up to the first that is known to be on a large one, a thousand at most.
  bool contains(const Mesh& mesh, Face f);

 private:
  std::vector<bool> known_;  // by face, those on large sheets
};

// Operators near the witnesses, untried: some may be refused themselves and most will not help. What adds or cuts comes
// before what takes away. At most a few dozen, without `orient`, which concerns the whole mesh. Cost: the elements at
// the witnesses, for `lone_edge` at worst the vertices of the mesh. `large` must know nothing of another mesh.
std::vector<AnyOp> remedy_candidates(const Mesh& mesh, const Reason& reason, LargeSheets& large);

}  // namespace ryosen
