// Prepares a mesh for an algorithm: cuts faces into triangles, and makes equal values of corners one, which is what
// operators know a chart of values by.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "ryosen/base/message.h"
#include "ryosen/mesh/edit.h"

namespace ryosen {

// The living faces of more than three corners or with rings.
std::vector<Face> polygons_of_mesh(const Mesh& mesh);

// A bridge within one loop shows as a halfedge whose twin has the same face.
bool has_bridge(const Mesh& mesh, Face f);

// Cuts faces by diagonals where that makes no edge twice, else from a new vertex in the middle. A clause that names the
// face where neither is possible; those before it are cut then.
std::optional<Text> cut_faces(Edit& edit, std::span<const Face> faces);

// What a sentence says of faces that were cut; empty where there are none.
Text cut_text(std::size_t cut_faces);

// Corners with the same value in two places of a pool refer to the first of them. O(corners).
void share_equal_values(Edit& edit);

}  // namespace ryosen
