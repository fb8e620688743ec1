// Values of elements that become one, or come to lie on one another.
#pragma once

#include <span>

#include "ryosen/mesh/edit.h"

namespace ryosen {

// Unites the values of two vertices at `along`, from the one that goes (0) to the one that stays (1). The nearer one
// comes first. Tells whether those of the one that stays have changed.
bool unite_ends(Edit& edit, Vertex gone, Vertex kept, double along);
// The same for the ends of h, which collapses, with the copies of the one that stays and the corners at both. Values
// stand at the numbers of vertices, which may be others than their slots. Cost: the copies and both valences, where
// there are attributes.
void merge_ends(Edit& edit, Halfedge h, double along, Vertex gone_number, Vertex kept_number);
// Before two points become one: unites their edges to common neighbours. Cost: the edges of the one that goes, where
// edges have attributes.
void unite_edges_at(Edit& edit, Vertex goes, Vertex stays);
// Gives all edges between the same points the values of these.
void share_among_sheets(Edit& edit, std::span<const Edge> edges);
// Gives new edges the values of an older one between the same points, where there is one.
void share_values(Edit& edit, std::span<const Edge> made);

}  // namespace ryosen
