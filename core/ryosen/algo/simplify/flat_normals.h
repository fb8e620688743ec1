// Normals at corners that are only those of their faces: nothing to simplify around, and made anew afterwards.
#pragma once

#include "ryosen/mesh/mesh.h"

namespace ryosen {

// Takes the normals of corners off a mesh where they are those of flat faces: all around each face the same one, about
// along it. False, and nothing is done, where the mesh has none or others. Equal values must share their place in the
// pool (preparation.h). O(corners).
bool take_flat_normals(Mesh& mesh);

// Gives the corners of each face the normal of the face, of length 1; none where it has no area. O(corners).
void put_flat_normals(Mesh& mesh);

}  // namespace ryosen
