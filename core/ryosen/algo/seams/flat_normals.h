// Normals of flat faces, which are no seams between them: they are taken off before faces change, and made anew
// afterwards.
#pragma once

#include <cstdint>
#include <vector>

#include "ryosen/mesh/descent.h"

namespace ryosen {

// Takes the normals off the corners of flat faces: all corners of one share a normal within 1 degree of its own, and so
// do those of each face that has the same one beyond an edge. By face, not 0 where it is flat; empty, and nothing is
// done, where there is none. Equal values must share their place in the pool (preparation.h). O(corners).
std::vector<std::uint8_t> take_flat_normals(Mesh& mesh);

// The same by face of a mesh that has come of that one, as the descent tells: parts of flat faces are flat. O(faces).
std::vector<std::uint8_t> flags_of_parts(const std::vector<std::uint8_t>& is_flat, const Mesh& parts,
                                         const Descent& descent);

// Gives the corners of these faces the normals that they had in the mesh before where a face is as it was there or
// looks the same way, and else the normal of the face, of length 1. A face without area keeps what it had. O(corners).
void put_flat_normals(Mesh& mesh, const std::vector<std::uint8_t>& is_flat, const Mesh& before);

}  // namespace ryosen
