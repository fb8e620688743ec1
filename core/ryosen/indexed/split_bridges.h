// Splitting of faces with bridges into loops before a polygon list is connected, and reassembly as rings afterwards.
#pragma once

#include <cstdint>
#include <vector>

#include "ryosen/indexed/indexed.h"
#include "ryosen/mesh/columns.h"

namespace ryosen {

// Replaces each face in source.bridged by its outer loop (the one with the largest area projected along the face's
// normal) and appends its other loops as further faces; returns the owning face of each of these. Corner values move
// along. O(corners) if there is such a face.
std::vector<std::uint32_t> split_bridges(IndexedMesh& source);

// Turns the faces from number `faces` on into rings of the faces they were split from.
void fold_rings(const std::vector<std::uint32_t>& face_of_ring, std::uint32_t faces, MeshColumns& columns);

}  // namespace ryosen
