// The meshes that the operators are let loose on.
#pragma once

#include <cstddef>

#include "ryosen/indexed/to_indexed.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen::fuzz {

struct Start {
  Mesh mesh;
  FileTables tables;
};

// Nothing; closed, open, non-manifold, misoriented and bow-tied surfaces; faces with rings, wires, lone points, a face
// set aside, values at corners.
std::size_t start_count();
Start start(std::size_t number);

}  // namespace ryosen::fuzz
