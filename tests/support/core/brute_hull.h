// The convex hull of a few points with small integer coordinates by trying every plane: an oracle that shares no code with
// the library.
#pragma once

#include <array>
#include <cstdint>
#include <set>
#include <span>
#include <vector>

namespace ryosen::test {

using GridPoint = std::array<std::int64_t, 3>;  // below 2^24 in magnitude

struct BruteHull {
  int dimension = -1;
  std::vector<std::uint32_t> vertices;          // ascending
  std::set<std::vector<std::uint32_t>> facets;  // each from its lowest number, counter-clockwise seen from outside

  friend bool operator==(const BruteHull&, const BruteHull&) = default;
};

// Of equal points the lowest number counts. Cost: O(n^4).
BruteHull brute_hull(std::span<const GridPoint> points);

}  // namespace ryosen::test
