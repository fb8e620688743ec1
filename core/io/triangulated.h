// A mesh cut into triangles, for formats that hold nothing else.
#pragma once

#include "core/io/mesh_file.h"

namespace ryosen {

// The same file with every face of more than three corners cut into triangles, which take its place one behind the
// other and share its names, colours and properties; corners keep their values. Faces in quarantine stay as they are,
// under the number that they have then. Cost: O(corners), see triangulate.h for a polygon.
MeshFile triangulated(const MeshFile& file);

// Whether it would differ.
bool has_polygons(const IndexedMesh& mesh);

}  // namespace ryosen
