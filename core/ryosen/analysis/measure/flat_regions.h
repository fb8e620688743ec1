// Flat parts of a surface, however they are cut into triangles.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "ryosen/analysis/measure/cell_bound.h"

namespace ryosen {

// Triangles that are joined by sides and lie in one plane. Where the triangle between the points that are nearest to
// the corners of a cell lies in one such region, no point of the cell is farther than the farthest corner: a cell above
// many triangles of one plane need not be cut by the sides of each, of which two discs cut in n thin triangles have n *
// n pairs.
class FlatRegions {
 public:
  // O(n log n). `to` must outlive it.
  explicit FlatRegions(const TriangleTree& to);

  // No point of the cell is farther than this; infinity where nothing is known. O(log n) where few sides of the border
  // of the region come near to the sides of the cell.
  double bound_of(const FarthestCell& cell) const;

 private:
  using Side = std::array<glm::dvec2, 2>;
  struct Region {
    std::size_t dropped = 0;  // the axis along which it is seen
    double turn = 1;          // the sign of its triangles seen so
    glm::dvec3 middle{0.0};
    double uneven = 0;                                  // how far a corner is from the plane
    std::uint32_t begin = 0, end = 0, root = no_index;  // in sides_, in nodes_
  };
  struct Node {
    glm::dvec2 lowest, highest;
    std::uint32_t begin, end, left = no_index, right = no_index;
  };
  using Corners = std::array<glm::dvec2, 3>;

  std::vector<std::array<std::uint32_t, 3>> find_neighbours() const;
  void grow(std::uint32_t from, const std::vector<std::array<std::uint32_t, 3>>& neighbours);
  void add_border(std::span<const std::uint32_t> triangles,
                  const std::vector<std::array<std::uint32_t, 3>>& neighbours);
  std::uint32_t add_node(std::uint32_t begin, std::uint32_t end);
  Corners seen(const TrianglePlaces& places, const Region& region) const;
  bool holds(const Region& region, std::uint32_t number, const TrianglePlaces& places, std::uint32_t hint) const;
  bool is_entered(const Region& region, const Corners& triangle) const;

  const TriangleTree& to_;
  std::vector<std::uint32_t> region_of_;  // by triangle
  std::vector<Region> regions_;
  std::vector<Side> sides_;
  std::vector<Node> nodes_;
};

}  // namespace ryosen
