// Triangulation of a mesh file, for formats that hold only triangles.
#pragma once

#include "ryosen/io/mesh_file.h"

namespace ryosen {

// The file with every face of more than three corners replaced by consecutive triangles, which share its names, colours
// and properties; corners keep their values. Quarantined faces are kept, renumbered. Cost: O(corners), see
// triangulate.h for a polygon.
MeshFile triangulated(const MeshFile& file);

// Whether triangulated() would change anything.
bool has_polygons(const IndexedMesh& mesh);

}  // namespace ryosen
