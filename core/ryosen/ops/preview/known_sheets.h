// A cache of the sheets of a mesh, for deciding which detachments to try.
#pragma once

#include <cstdint>
#include <unordered_map>

#include "ryosen/mesh/mesh.h"

namespace ryosen {

// Valid while the mesh does not change. Cost of a query: the faces of the sheet, at most 1000 or up to the first one
// known to be on a large sheet, and their one-rings.
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

}  // namespace ryosen
