// Elements of a file beside its mesh, and conversion of an edited mesh back to a MeshFile.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ryosen/indexed/to_indexed.h"
#include "ryosen/io/mesh_file.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

// The lines and points of a file, and the rows of its other elements that name their ends (edges of PLY), as lines.
struct ElementTotals {
  std::uint64_t lines = 0, points = 0;
};
ElementTotals totals_of(const MeshFile& file);
// The vertices of the file that these lines use, and lists such as the strips of PLY, ascending: they are not isolated;
// a vertex that only a point names may be.
std::vector<Vertex> vertices_on_lines(const MeshFile& file, std::size_t file_vertices);

// `vertex_number` and `face_number` give the new number for each old one, no_index if removed; faces keep their order.
// A number past `old_vertices` stays equally far past `new_vertices`, negative ones are unchanged. Removed vertices are
// dropped from lines and points; lines left with fewer than two vertices and empty point lists are removed, unless the
// file had them. Cost: O(faces + elements).
ElementList renumbered(const ElementList& elements, std::span<const std::uint32_t> vertex_number,
                       std::span<const std::uint32_t> face_number, std::size_t old_vertices, std::size_t new_vertices);

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
