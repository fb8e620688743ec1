// What may help against one reason for a refusal.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/ops/all.h"

namespace ryosen {

// What is known of the sheets of a mesh whose detachment may be tried. It is kept, so ask one again while the mesh stays
// as it is. Cost of a question: the faces of the sheet up to the first that is known to be on a large one, a thousand at
// most, and their stars.
class KnownSheets {
 public:
  // Whether the sheet of the face has so many faces that it is not tried.
  bool is_large(const Mesh& mesh, Face f) { return key(mesh, f) == large; }
  // The same number for faces of a small sheet whose detachments are one and the same: all of them, or, where the sheet
  // touches no other face, each for itself.
  std::uint32_t key(const Mesh& mesh, Face f);

  static constexpr std::uint32_t large = no_index;

 private:
  std::unordered_map<Face, std::uint32_t> keys_;
};

// Operators near the witnesses, untried: some may be refused themselves and most will not help. What adds or cuts comes
// before what takes away. At most a few dozen, without `orient`, which concerns the whole mesh. Cost: the elements at
// the witnesses, for `lone_edge` at worst the vertices of the mesh. `sheets` must know nothing of another mesh.
std::vector<AnyOp> remedy_candidates(const Mesh& mesh, const Reason& reason, KnownSheets& sheets);

}  // namespace ryosen
