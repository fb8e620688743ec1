// Renumbering of the lines and points of a file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "ryosen/io/mesh_file.h"

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

}  // namespace ryosen
