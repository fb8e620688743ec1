// Carries the lines and points of a file along when vertices and faces get new numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/io/mesh_file.h"

namespace ryosen {

// The lines and points of a file, and the rows of its other elements that name vertices (edges of PLY), as lines.
struct ElementTotals {
  std::uint64_t lines = 0, points = 0;
};
ElementTotals totals_of(const MeshFile& file);

// `vertex_number` and `face_number` give the new number for each old one, no_index for what is gone; faces keep their
// order. The file had `old_vertices` vertices and gets `new_vertices`: a number past the old end stays as far past the
// new one, negative ones stay. A vertex that is gone leaves its line or points; a line of fewer than two and points of
// none go too, unless the file had them so. Cost: O(faces + elements).
ElementList renumbered(const ElementList& elements, std::span<const std::uint32_t> vertex_number,
                       std::span<const std::uint32_t> face_number, std::size_t old_vertices, std::size_t new_vertices);

}  // namespace ryosen
