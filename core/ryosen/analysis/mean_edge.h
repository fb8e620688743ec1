// How long the edges of a mesh are on the whole.
#pragma once

#include "ryosen/mesh/mesh.h"

namespace ryosen {

// Of all live edges whose length is finite; 0 where there is none. O(edges).
double mean_edge_length(const Mesh& mesh);

}  // namespace ryosen
