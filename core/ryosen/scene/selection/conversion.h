// Turns what is selected into elements of another kind.
#pragma once

#include <span>

#include "ryosen/base/element.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// Elements of the kind stay. Downwards it is all that belongs to something selected: the sides and corners of faces,
// the ends of edges. Upwards it is what lies wholly in the selection: an edge with both ends, a face with all corners;
// where there is no such thing, what meets it. Halfedges are those of a face. Ascending, points in place of vertices.
// O(corners).
Elements converted(const Mesh& mesh, std::span<const Element> selection, Element::Kind to);

}  // namespace ryosen
