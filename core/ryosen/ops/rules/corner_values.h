// Updates of corner attributes (texture coordinates, normals) by operators.
#pragma once

#include <functional>
#include <span>

#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/edit.h"

namespace ryosen {

// Takes away the normal of a corner, which belongs to another surface.
void drop_normal(Edit& edit, Halfedge corner);

// Whether the values at the two ends of an edge differ between its two faces.
bool is_seam(const Mesh& mesh, Halfedge h);

// Call before removing these edges (sorted) and merging the faces at them. Corners that will be merged take the values
// of the corner in the lowest-numbered face; `number` says by which number a face goes.
using NumberOfFace = std::function<std::uint32_t(Face)>;
void merge_corner_values(
    Edit& edit, std::span<const Edge> edges_that_go, const NumberOfFace& number = [](Face f) { return f.index; });

}  // namespace ryosen
