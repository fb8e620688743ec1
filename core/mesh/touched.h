// What a transaction changed, as elements: for everything that is kept current through edits, undo and redo.
#pragma once

#include <vector>

#include "core/mesh/journal.h"
#include "core/mesh/mesh.h"

namespace ryosen {

// Sorted, without repetition. Slots may be dead or lie past the end of the columns (elements that an undo took away).
struct TouchedElements {
  bool everything = false;       // columns were replaced whole; the lists are empty then
  std::vector<Vertex> vertices;  // links, position or values
  std::vector<Vertex> moved;     // position
  std::vector<Halfedge> halfedges;
  std::vector<Face> faces;  // corner list, or the position of a corner
};

// What transaction i changes between the two states around it. Call it in either state, right after the commit, undo or
// redo of i. Cost: the cells written, and the stars of moved vertices.
TouchedElements touched_elements(const Mesh& mesh, const Journal& journal, std::size_t i);

}  // namespace ryosen
