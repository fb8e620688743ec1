// Which faces of a list of triangles on places of whole numbers bound closed parts: the rule of pair_faces.h, read word
// by word, by trying all and with whole numbers only. Slow.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "ryosen/mesh/mesh.h"
#include "tests/support/core/solids.h"

namespace ryosen::test {

// Points may lie at one place.
struct TriangleList {
  std::vector<LatticePoint> places;               // by point
  std::vector<std::array<std::size_t, 3>> faces;  // points
};

// The triangles of a mesh on places of whole numbers.
TriangleList triangles_of(const Mesh& mesh);

struct PairedList {
  std::vector<bool> is_closed, is_free;  // by face
  std::vector<std::size_t> open_sides;   // by face: at edges of one face, and of free ones at edges of three or more
  std::vector<std::pair<std::size_t, std::size_t>> sides_alike;  // face and corner, at edges of two in one direction
};

PairedList pair_by_asking_all(const TriangleList& list);

}  // namespace ryosen::test
