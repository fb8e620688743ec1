// What a transaction changed, as elements: for everything that is kept current through edits, undo and redo.
#pragma once

#include <vector>

#include "core/mesh/journal.h"
#include "core/mesh/mesh.h"

namespace ryosen {

// Sorted, without repetition. Slots may be dead or lie past the end of the columns (elements that an undo took away).
// Elements that the transaction makes, or its undo takes away, stand in all lists of their kind. Values are not told.
struct TouchedElements {
  bool everything = false;          // columns were replaced whole; the lists are empty then
  std::vector<Vertex> vertices;     // its link, its position, or a link of an outgoing halfedge was written
  std::vector<Vertex> moved;        // its position was written
  std::vector<Halfedge> halfedges;  // a link was written
  std::vector<Face> faces;          // its link or that of a side was written, or a corner moved
};

// What transaction i changes between the two states around it. Call it in either state, right after the commit, undo or
// redo of i. Cost: the cells written, and the stars of moved vertices.
TouchedElements touched_elements(const Mesh& mesh, const Journal& journal, std::size_t i);

}  // namespace ryosen
