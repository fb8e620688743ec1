// The attributes of a mesh that is built from a polygon list, and of a list that is made of a mesh.
#pragma once

#include "ryosen/indexed/indexed.h"
#include "ryosen/indexed/pair_corners.h"
#include "ryosen/indexed/to_indexed.h"
#include "ryosen/mesh/columns.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// Adds one column per attribute that the list uses (names in ryosen/mesh/attribute.h). Copies take the values of their
// point, all halves of an edge those of the edge. Linear in the size of the attributes, and a sort of the listed edges.
void add_attributes(const IndexedMesh& source, const CornerPairing& pairing, MeshColumns& c);

// Whether the mesh has free attributes (attribute.h) of this kind of elements.
bool has_free_attributes(const Mesh& mesh, ElementKind element);
// Fills the free attributes and the edges of a list whose elements are numbered. `corners` has the corners of the mesh
// by place in the list; it is read only where the mesh has free attributes of corners. O(values), and a sort of the
// listed edges.
void list_attributes(const Mesh& mesh, const std::vector<std::uint32_t>& corners, CompactMesh& out);

// A corner of a list that a face with bridges visits again, `visit` of its corners in the file; `first` was the other.
struct RepeatedCorner {
  std::size_t place;  // in the list
  const BridgedFace* face;
  std::size_t visit, first;
};
// Gives such a corner the value that the file has there, where that of its first visit is unchanged.
void restore_repeated(std::span<const RepeatedCorner> corners, CompactMesh& out);

// The corner attributes of a list, without values.
std::vector<AttributeColumn> quarantined_attributes(const IndexedMesh& source);
// Gives faces that have the values of the corner attributes `before` those of the ones among `now`: the default for an
// attribute that is new or has another type.
void renew_quarantined_values(std::span<QuarantinedFace> faces, std::span<const AttributeColumn> before,
                              std::span<const AttributeColumn> now);

}  // namespace ryosen
