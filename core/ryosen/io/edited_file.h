// Conversion of an edited mesh back to a MeshFile.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "ryosen/indexed/to_indexed.h"
#include "ryosen/io/mesh_file.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// The file vertices referenced by quarantined faces, lines and points, or extra elements such as edges; ascending.
std::vector<Vertex> used_beside_the_mesh(const MeshFile& source, std::span<const QuarantinedFace> quarantine,
                                         std::size_t file_vertices);

// The file with the current mesh: all other data are renumbered with its vertices and faces, and a vertex they
// reference is kept even if it was removed from the mesh (MeshFile::kept_vertices). `source` is the file as read, whose
// IndexedMesh may have been moved into from_indexed; `tables` are those of that list. O(file).
MeshFile edited_file(const MeshFile& source, const Mesh& mesh, const FileTables& tables);

// Leaves out the texture coordinates and normals that no corner uses, faces set aside and lines included: what edits
// left over. Values of isolated vertices stay. O(file).
void drop_unused_values(MeshFile& file);

}  // namespace ryosen
