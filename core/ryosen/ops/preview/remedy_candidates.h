// Candidate remedies for one reason of a refusal.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "ryosen/mesh/mesh.h"
#include "ryosen/ops/all.h"

namespace ryosen {

// A cache of the sheets of a mesh, for deciding which detachments to try. Valid while the mesh does not change. Cost of
// a query: the faces of the sheet, at most 1000 or up to the first one known to be on a large sheet, and their
// one-rings.
class KnownSheets {
 public:
  // Whether the sheet of the face is too large to try.
  bool is_large(const Mesh& mesh, Face f) { return key(mesh, f) == large; }
  // Equal for faces of a small sheet whose detachment is the same operation: all faces of the sheet, or each face
  // separately if the sheet touches no other face. `large` for large sheets.
  std::uint32_t key(const Mesh& mesh, Face f);
  // Equal for all faces of a small sheet; `large` for all faces of large ones.
  std::uint32_t number(const Mesh& mesh, Face f) { return find(mesh, f).number; }

  static constexpr std::uint32_t large = no_index;

 private:
  struct Sheet {
    std::uint32_t number = large;  // its face that was asked for first
    bool touches = false;          // a face of another sheet
  };
  const Sheet& find(const Mesh& mesh, Face f);

  std::unordered_map<Face, Sheet> sheets_;
};

// Operators near the witnesses, unverified: some may be refused themselves and most will not help. Additions and splits
// come before deletions. At most a few dozen, without `orient`, which affects the whole mesh. Cost: the elements at the
// witnesses, for `lone_edge` worst case all vertices. `sheets` must be a cache for this mesh.
std::vector<AnyOp> remedy_candidates(const Mesh& mesh, const Reason& reason, KnownSheets& sheets);

}  // namespace ryosen
