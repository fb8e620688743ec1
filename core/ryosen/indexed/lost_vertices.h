// File vertices that were deleted from the mesh but are still referenced from outside it.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "ryosen/indexed/to_indexed.h"

namespace ryosen {

// How such vertices are written: kept, or replaced by a live point.
struct LostVertices {
  std::vector<Vertex> kept;                             // ascending
  std::vector<std::pair<Vertex, Vertex>> replacements;  // deleted vertex, live point that replaces it
};

// Considers the vertices referenced by the quarantine in `tables` and by `used_beside`; see to_indexed for which points
// replace them. Linear in the references, plus a sort of the points if one of them was deleted.
LostVertices find_lost(const Mesh& mesh, const FileTables& tables, std::span<const Vertex> used_beside);

}  // namespace ryosen
