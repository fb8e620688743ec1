// Conversion of a face with rings or bridges to the single corner list that files use.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "ryosen/mesh/rings.h"

namespace ryosen {

// Whether the single corner list of the face repeats a vertex: it has rings or a bridge. O(corners).
bool visits_a_corner_twice(const Mesh& mesh, Face f);

// The corners of the face in the order of `list`, its corner list in the file: each as its halfedge and the index in
// the list of that corner. None if the loops of the face have changed since, or a bridge in the mesh is not in the
// list.
std::optional<std::vector<std::pair<Halfedge, std::size_t>>> corners_as_in_file(const Mesh& mesh, Face f,
                                                                                std::span<const std::uint32_t> list);

// The loops joined by the shortest visible bridges; bridges that are edges of the mesh are kept.
std::vector<Halfedge> corners_with_bridges(const Mesh& mesh, Face f);

}  // namespace ryosen
