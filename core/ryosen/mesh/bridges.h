// Bridges: edges that a face traverses in both directions; files use them to write a face with holes as one corner
// list.
//
//     3-----------2          the list 0 1 2 3 0 4 7 6 5 4 traverses 0-4 in both directions; without it the outer loop
//     |  7-----6  |          0 1 2 3 and the ring 4 7 6 5 remain
//     |  |     |  |
//     |  4-----5  |
//     |/          |
//     0-----------1
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ryosen {

// The corner lists of one face, concatenated: vertex numbers, and the end index of each list.
struct CornerLoops {
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> ends;

  void add(std::span<const std::uint32_t> loop);
};

// The loops that remain when the edges traversed in both directions are removed, as indices into `corners`; each starts
// at its lowest index, and they are sorted by it. None if removing such an edge does not split a loop in two, or if a
// remaining loop has fewer than three corners or two of them share a vertex. O(n log n).
std::optional<std::vector<std::vector<std::uint32_t>>> take_out_bridges(const CornerLoops& loops);
// Loops without bridges in canonical form, independent of where each starts: of vertex numbers, each from its smallest
// one on, and sorted.
std::vector<std::vector<std::uint32_t>> normal_form(const CornerLoops& loops,
                                                    const std::vector<std::vector<std::uint32_t>>& parts);

}  // namespace ryosen
