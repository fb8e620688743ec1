// The ways to find the pairs among the sides of a polygon list that the source texts name, beside the one in use.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/indexed/indexed.h"

namespace ryosen {

// For each corner the corner whose side it is joined with, or no_index. The side of a corner runs to the next corner of
// its face. Two sides are joined when they run between the same two points in opposite directions and no third side
// runs there; all others stay alone.
using SidePartners = std::vector<std::uint32_t>;

struct PairingMethod {
  std::string_view id;
  std::string_view en, ja;
  // Corner lists must be in range and without a repeated point.
  SidePartners (*pair)(const IndexedMesh& source);
  // About how many sides are looked at, to tell beforehand whether it will take long. O(corners).
  double (*steps)(const IndexedMesh& source);
};

// Brute force, hash with the source texts' key and with a good one, vertex lists, sparse matrix, sort, and the one in use
// (pair_corners). All give the same partners.
std::span<const PairingMethod> pairing_methods();

// The key of the source texts for the hash: the smaller number in the low half, the larger one moved up by 16 bits. It is
// unique only below 65,536 points.
constexpr std::uint32_t sixteen_bit_key(std::uint32_t a, std::uint32_t b) {
  const std::uint32_t low = a < b ? a : b, high = a < b ? b : a;
  return low | (high << 16u);
}

// The first faces of a list with all its points, so that a slow method can be measured on a part. count <= faces.
IndexedMesh first_faces(const IndexedMesh& source, std::size_t count);

}  // namespace ryosen
