// The pieces in which a surface is sampled, and the cells of each.
#pragma once

#include <cstdint>
#include <vector>

#include "ryosen/analysis/measure/cell_bound.h"

namespace ryosen {

// A triangle of the surface, or one of the equal parts of a large one, that is sampled in cells * cells equal cells.
struct SampledPiece {
  std::uint32_t triangle, parts, part, cells;
};
constexpr std::uint32_t most_cells = 64;  // per side of a piece

inline double area_of(const TrianglePlaces& t) { return 0.5 * glm::length(glm::cross(t[1] - t[0], t[2] - t[0])); }

inline TrianglePlaces places_of(const TriangleTree& tree, const SampledPiece& piece) {
  return subtriangle(tree.places(piece.triangle), piece.parts, piece.part);
}

// Of a piece that is a whole triangle.
inline bool is_corner(const SampledPiece& piece, std::uint32_t line, std::uint32_t along) {
  return line == 0 || (line == piece.cells && (along == 0 || along == line));
}

inline std::size_t lattice_index(std::uint32_t line, std::uint32_t along) {
  return std::size_t{line} * (line + 1) / 2 + along;
}

// The cells of a piece with what is nearest to their corners: visit(number, cell).
template <class Visit>
void for_each_cell(const SampledPiece& piece, const TrianglePlaces& places,
                   const std::vector<TriangleTree::Near>& lattice, const Visit& visit) {
  std::uint32_t number = 0;
  const auto at = [&](std::uint32_t line, std::uint32_t along) { return lattice[lattice_index(line, along)]; };
  for (std::uint32_t line = 0; line < piece.cells; ++line)
    for (std::uint32_t place = 0; place <= 2 * line; ++place, ++number) {
      const std::uint32_t along = place / 2;
      FarthestCell cell{subtriangle(places, piece.cells, number), {}};
      if (place % 2 == 0)
        cell.near = {at(line, along), at(line + 1, along), at(line + 1, along + 1)};
      else
        cell.near = {at(line, along), at(line + 1, along + 1), at(line, along + 1)};
      visit(number, cell);
    }
}

}  // namespace ryosen
