// Seams: edges at which what the corners of two faces carry does not go together.
#pragma once

#include "ryosen/analysis/neighbourhood.h"

namespace ryosen {

// Whether exactly two faces share the edge on points and the values of their corners (texture coordinates, normals)
// differ at one of its ends. The lowest sheet with a face answers for the edge.
bool is_seam_edge(Neighbourhood& around, Edge e);

}  // namespace ryosen
