// The pairing methods of the source texts (matching opposite sides of a polygon list), for comparison with the one in
// use.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "ryosen/indexed/indexed.h"

namespace ryosen {

// For each corner the corner whose side is its partner, or no_index. The side of a corner goes to the next corner of
// its face. Two sides are partners if they join the same two points in opposite directions and there is no third side
// between these.
using SidePartners = std::vector<std::uint32_t>;

struct PairingMethod {
  std::string_view id;
  std::string_view en, ja;
  // Corner lists must be in range and without a repeated point.
  SidePartners (*pair)(const IndexedMesh& source);
  // The same, and how often two sides, or two keys of sides, were compared.
  SidePartners (*pair_counting)(const IndexedMesh& source, std::uint64_t& comparisons);
  // Estimated number of sides visited, to predict the run time. O(corners).
  double (*steps)(const IndexedMesh& source);
};

// Brute force, hashing with the source texts' key and with a good one, vertex lists, sparse matrix, sorting, and the
// one in use (pair_corners). All give the same partners.
std::span<const PairingMethod> pairing_methods();

// The hash key of the source texts: the smaller number plus the larger one shifted left by 16 bits. Collision-free only
// below 65,536 points.
constexpr std::uint32_t sixteen_bit_key(std::uint32_t a, std::uint32_t b) {
  const std::uint32_t low = a < b ? a : b, high = a < b ? b : a;
  return low | (high << 16u);
}

// The first `count` faces of a list with all its points, for measuring slow methods on a part. count <= faces.
IndexedMesh first_faces(const IndexedMesh& source, std::size_t count);

}  // namespace ryosen
