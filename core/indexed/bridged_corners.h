// The one corner list in which files write a face with rings.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/mesh/rings.h"

namespace ryosen {

// Whether one list of the face's corners names a vertex twice: a face with rings or a bridge. O(corners).
bool visits_a_corner_twice(const Mesh& mesh, Face f);

// The corners along a list of points that the face once had, each as its halfedge and the place of the list that this
// corner stands for; none where the loops of the list are no longer those of the face, or a bridge in the mesh is
// none of the list.
std::optional<std::vector<std::pair<Halfedge, std::size_t>>> corners_as_in_file(const Mesh& mesh, Face f,
                                                                                std::span<const std::uint32_t> list);

// The loops joined by the shortest visible bridges; those that the face has in the mesh stay.
std::vector<Halfedge> corners_with_bridges(const Mesh& mesh, Face f);

}  // namespace ryosen
