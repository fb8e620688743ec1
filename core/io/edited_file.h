// The way back from an edited mesh to the file that it came from.
#pragma once

#include <cstddef>
#include <vector>

#include "core/indexed/to_indexed.h"
#include "core/io/mesh_file.h"
#include "core/mesh/mesh.h"

namespace ryosen {

// The vertices of the file that faces set aside, its lines and points, or elements of their own (edges) name; ascending.
std::vector<Vertex> used_beside_the_mesh(const MeshFile& source, const FileTables& tables, std::size_t file_vertices);

// The file with the mesh as it is now: everything beside the mesh follows its vertices and faces to their new numbers,
// and a vertex that it uses stays also where it is gone from the mesh (MeshFile::kept_vertices).
// `source` is the file as it was read, of which IndexedMesh may have been given away to from_indexed; `tables` are those
// of that list. O(file).
MeshFile edited_file(const MeshFile& source, const Mesh& mesh, const FileTables& tables);

}  // namespace ryosen
