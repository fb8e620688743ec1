// The sheets of a mesh whose detachment may be tried.
#pragma once

#include <cstdint>
#include <unordered_map>

#include "core/mesh/mesh.h"

namespace ryosen {

// What is known of them. It is kept, so ask one again while the mesh stays as it is. Cost of a question: the faces of
// the sheet up to the first that is known to be on a large one, a thousand at most, and their stars.
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

}  // namespace ryosen
