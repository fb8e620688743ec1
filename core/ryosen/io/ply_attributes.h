// Attributes of PLY files: properties of vertices, faces and edges that have no meaning of their own.
//
//   element vertex 3                                     comment attribute corner.fixed bool first false
//   property float load     -> vertex.load               element face 1
//   element edge 1                                       property list uchar int vertex_indices
//   property int vertex1       the ends                  property list uchar uchar corner.fixed
//   property int vertex2
//   property uchar crease   -> edge.crease
#pragma once

#include <vector>

#include "ryosen/io/mesh_file.h"
#include "ryosen/io/ply_header.h"

namespace ryosen {

// Moves properties from the tables of a file to the attributes of its mesh: numbers, and the lists that a comment
// describes if their lengths fit. Reserved and repeated names stay in the tables, and comments that describe no
// property return to the comments. The rows of the element edge whose ends an edge of a face joins become edges of the
// list, the first one of each pair of ends; the others stay in the table. O(values), and a sort of the corners where
// there are edges.
void take_attributes(MeshFile& file, std::vector<PlyAttribute> described);

// Whether reading the property gives the attribute without a comment.
bool is_plain_in_ply(const AttributeColumn& column);

}  // namespace ryosen
