// The meshes that benchmarks run on.
#pragma once

#include <string>

#include "core/build/indexed.h"

namespace ryosen::bench {

// The bunny of the project, without attributes.
const IndexedMesh& bunny();
// The dragon, from the gzipped ASCII PLY that RYOSEN_DRAGON names; empty when it is not set.
const IndexedMesh& dragon();

}  // namespace ryosen::bench
