// Bridges: edges that a face walks both ways, as files write a face with holes in one corner list.
//
//     3-----------2          the list 0 1 2 3 0 4 7 6 5 4 walks 0-4 both ways; taken out, the outer loop 0 1 2 3 and
//     |  7-----6  |          the ring 4 7 6 5 are left
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

// Corner lists of one face, one behind the other: numbers of vertices, and one past the last place of each list.
struct CornerLoops {
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> ends;

  void add(std::span<const std::uint32_t> loop);
};

// The loops that are left when the edges that the lists walk both ways are taken out, as places in `corners`; in the
// order of their lowest place, from it. None where a loop does not come apart at each of these edges, or where the
// loops that are left have fewer than three corners or share a vertex. O(n log n).
std::optional<std::vector<std::vector<std::uint32_t>>> take_out_bridges(const CornerLoops& loops);

}  // namespace ryosen
