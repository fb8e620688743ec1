// Which faces of a list of triangles on places of whole numbers bound closed parts: the rule of pair_faces.h, read word
// by word, by trying all and with whole numbers only. Slow.
#pragma once

#include <vector>

#include "tests/support/core/solids.h"

namespace ryosen::test {

struct PairedList {
  std::vector<bool> is_closed, is_free;  // by face
  std::size_t free_sides = 0;            // sides of free faces at edges of three or more faces
  std::size_t misoriented = 0;           // edges of two faces in one direction
  std::size_t boundary = 0;              // edges of one face
};

PairedList pair_by_asking_all(const std::vector<std::vector<LatticePoint>>& faces);

}  // namespace ryosen::test
