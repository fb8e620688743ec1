// What problems are about, beside the element that has them: rows of the table of problems name these
// (ProblemRow::about).
#pragma once

#include <vector>

#include "ryosen/analysis/neighbourhood.h"
#include "ryosen/base/element.h"
#include "ryosen/base/index_set.h"

namespace ryosen {

// The boundary loop that a boundary edge is in, in traversal order from the edge, or the edge alone where its chain
// ends at a non-manifold edge. O(boundary edges).
std::vector<Element> loop_of_edge(Neighbourhood& around, const IndexSet& boundary, Element edge);
// The edge and the faces at its points.
std::vector<Element> edge_with_faces(Neighbourhood& around, const IndexSet&, Element edge);
// The vertex and the faces at all its copies.
std::vector<Element> vertex_with_fans(Neighbourhood& around, const IndexSet&, Element vertex);
// The face and all others on the same points.
std::vector<Element> equal_faces_of(Neighbourhood& around, const IndexSet&, Element face);
// The vertex and all others at its place. O(members).
std::vector<Element> points_at_place(Neighbourhood& around, const IndexSet& members, Element vertex);
// The two triangles of a hanging pair.
std::vector<Element> pair_of_face(Neighbourhood& around, const IndexSet&, Element face);

}  // namespace ryosen
