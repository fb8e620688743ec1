// The pairs of faces that meet elsewhere, by asking each pair of triangles.
#pragma once

#include <vector>

#include "ryosen/analysis/self_intersections.h"
#include "ryosen/indexed/indexed.h"

namespace ryosen::test {

// Of a mesh whose faces are triangles with finite points; those whose corners lie on a line are left out. Ascending.
std::vector<FacePair> pairs_by_asking_all(const IndexedMesh& mesh);

}  // namespace ryosen::test
