// Selections that come from a selection: what it grows to along the mesh, and its elements turned into another kind.
//
// Elements are neighbours of their own kind if they touch at a point, vertices if an edge joins them. Copies of a point
// count as the point. Each function keeps the order of what was selected and puts what is new behind it. Cost: the
// selection and what it grows by, but for a bit per slot of the mesh.
#pragma once

#include <span>
#include <vector>

#include "ryosen/base/element.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// With all neighbours.
Elements grown(const Mesh& mesh, std::span<const Element> selection);
// Without the elements that have a neighbour which is not selected.
Elements shrunk(const Mesh& mesh, std::span<const Element> selection);
// With all that grown() reaches when it is done again and again: the parts that the elements belong to.
Elements linked(const Mesh& mesh, std::span<const Element> selection);

// The edges that run on from the selected edges and halfedges, both ways: straight on through vertices with four edges
// that have faces all around, along the whole boundary from one of its edges.
//
//     ---o---o---o---        the loop of the middle edge is the row -o-o-o-
//     |  |   |   |  |
Elements edge_loops(const Mesh& mesh, std::span<const Element> selection);
// The edges across from the selected edges and halfedges, from quad to quad, both ways.
//
//     o---o---o---o          the ring of | is | | | |
//     |   |   |   |
//     o---o---o---o
Elements edge_rings(const Mesh& mesh, std::span<const Element> selection);

// The faces that are reached from the selected ones over edges with two faces that bend by at most this angle, and over
// those at faces that have no normal.
Elements flat_regions(const Mesh& mesh, std::span<const Element> selection, double angle_deg);

// What is selected, turned into elements of another kind. Elements of the kind stay. Downwards it is all that belongs
// to something selected: the sides and corners of faces, the ends of edges. Upwards it is what lies wholly in the
// selection: an edge with both ends, a face with all corners; where there is no such thing, what meets it. Halfedges
// are those of a face. Ascending, points in place of vertices. O(corners).
Elements converted(const Mesh& mesh, std::span<const Element> selection, Element::Kind to);

}  // namespace ryosen
