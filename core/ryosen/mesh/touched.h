// The elements that a transaction changed: for everything that is updated incrementally through edits, undo and redo.
#pragma once

#include <vector>

#include "ryosen/mesh/journal.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// Sorted, without duplicates. Slots may be dead or past the end of the columns (elements removed by an undo). Elements
// that the transaction creates, or its undo removes, are in all lists of their kind. Attribute changes are not
// reported.
struct TouchedElements {
  bool everything = false;          // columns were replaced whole; the lists are empty then
  std::vector<Vertex> vertices;     // its link, its position, or a link of an outgoing halfedge was written
  std::vector<Vertex> moved;        // its position was written
  std::vector<Halfedge> halfedges;  // a link was written
  std::vector<Face> faces;          // its link or that of a side was written, or a corner moved
};

// The elements that differ between the states before and after transaction i. Call it in either state, right after the
// commit, undo or redo of i. Cost: the cells written, and the one-rings of moved vertices.
TouchedElements touched_elements(const Mesh& mesh, const Journal& journal, std::size_t i);

}  // namespace ryosen
