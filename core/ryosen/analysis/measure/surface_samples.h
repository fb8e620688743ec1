// A surface measured at samples: the pieces in which it is sampled, and the cells of each.
#pragma once

#include <cstdint>
#include <vector>

#include "ryosen/analysis/measure/cell_bound.h"
#include "ryosen/analysis/measure/distance.h"
#include "ryosen/analysis/measure/farthest.h"

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

struct SampleSums {
  double weight = 0, distance = 0, square = 0;
  std::uint64_t samples = 0;
};

// A cell whose bound may be larger than the largest distance found. Bounds are floats that are not below it.
struct OpenSample {
  std::uint32_t piece, cell;
  float bound;
  std::array<std::uint32_t, 3> near;  // what is nearest to its corners
};

struct SurfaceSamples {
  std::vector<SampledPiece> pieces;
  double area = 0;
  SampleSums sums;
  Farthest farthest;             // the bound is that of all cells but the open ones
  std::vector<OpenSample> open;  // in no order

  FarthestCell cell(const TriangleTree& from, const TriangleTree& to, const OpenSample& open) const;
};

// Where its progress is then, of the whole of one way.
constexpr double share_of_samples = 0.75;

// Of `from`, about options.samples, in units of the trees. The same for any number of threads. False where `progress`
// cancels.
bool take_samples(SurfaceSamples& samples, const TriangleTree& from, const TriangleTree& to,
                  const DistanceOptions& options, FarEnough enough, unsigned threads, Progress& progress);

}  // namespace ryosen
