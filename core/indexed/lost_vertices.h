// The vertices of a file that are gone from the mesh and that something beside it uses.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "core/indexed/to_indexed.h"

namespace ryosen {

// What becomes of vertices that are gone and that something beside the mesh uses.
struct LostVertices {
  std::vector<Vertex> kept;                             // ascending
  std::vector<std::pair<Vertex, Vertex>> replacements;  // and the live point that stands for it
};

// Of those that the faces set aside in `tables` name, and of `used_beside`; which points stand for them is said at
// to_indexed. O(those named), and a sort of the points when one of them is gone.
LostVertices find_lost(const Mesh& mesh, const FileTables& tables, std::span<const Vertex> used_beside);

}  // namespace ryosen
