// Faces whose corner lists have bridges, taken apart before a polygon list is connected and put together afterwards.
#pragma once

#include <cstdint>
#include <vector>

#include "core/indexed/indexed.h"
#include "core/mesh/columns.h"

namespace ryosen {

// Leaves the outer loop of each face in source.bridged in its place, the one with the largest area projected along the
// face's normal, and adds its other loops as further faces at the end; returns the face of each of these. Corner values
// come along. Cost: O(corners) where there is such a face.
std::vector<std::uint32_t> unfold_bridges(IndexedMesh& source);

// Makes the faces from `faces` on rings of the faces that they were unfolded from.
void fold_rings(const std::vector<std::uint32_t>& face_of_ring, std::uint32_t faces, MeshColumns& columns);

}  // namespace ryosen
