// The meshes that benchmarks run on.
#pragma once

#include <string>

#include "ryosen/indexed/indexed.h"

namespace ryosen::bench {

// The bunny of the project, without attributes.
const IndexedMesh& bunny();
// A sheet of about 70,000 or 830,000 triangles, full of findings: at every ninth square a third triangle on the
// diagonal, which makes copies, and a triangle by itself above another square, which has a boundary loop of its own.
const IndexedMesh& littered_70k();
const IndexedMesh& littered_830k();
// The dragon, from the gzipped ASCII PLY that RYOSEN_DRAGON names; empty when it is not set.
const IndexedMesh& dragon();

// The same mesh with its positions rounded to floats.
IndexedMesh in_floats(IndexedMesh mesh);

}  // namespace ryosen::bench
