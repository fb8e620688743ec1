// Conversion of the attributes of a polygon list to mesh columns.
#pragma once

#include "core/indexed/indexed.h"
#include "core/indexed/pair_corners.h"
#include "core/mesh/columns.h"

namespace ryosen {

// Adds one column per attribute that the list uses (names in core/mesh/attribute.h). Copies take the values of their
// point. Linear in the size of the attributes.
void add_attributes(const IndexedMesh& source, const CornerPairing& pairing, MeshColumns& columns);

}  // namespace ryosen
