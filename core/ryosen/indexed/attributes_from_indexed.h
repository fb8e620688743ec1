// Conversion of the attributes of a polygon list to mesh columns.
#pragma once

#include "ryosen/indexed/indexed.h"
#include "ryosen/indexed/pair_corners.h"
#include "ryosen/mesh/columns.h"

namespace ryosen {

// Adds one column per attribute that the list uses (names in ryosen/mesh/attribute.h). Copies take the values of their
// point. Linear in the size of the attributes.
void add_attributes(const IndexedMesh& source, const CornerPairing& pairing, MeshColumns& columns);

}  // namespace ryosen
