// Cutting faces into triangles before an algorithm that needs them.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "ryosen/base/message.h"
#include "ryosen/mesh/edit.h"

namespace ryosen {

// The living faces of more than three corners or with rings.
std::vector<Face> polygons_of_mesh(const Mesh& mesh);

// Cuts them by diagonals where that makes no edge twice, else from a new vertex in the middle. A clause that names the
// face where neither is possible; those before it are cut then.
std::optional<Text> cut_faces(Edit& edit, std::span<const Face> faces);

}  // namespace ryosen
