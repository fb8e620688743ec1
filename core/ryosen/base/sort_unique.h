// Sorting with removal of duplicates.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "ryosen/base/handle.h"

namespace ryosen {

// Sorts the values and removes duplicates.
template <class Values>
void sort_unique(Values& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

// Compiled once: most of the program sorts these.
extern template void sort_unique(std::vector<Vertex>&);
extern template void sort_unique(std::vector<Halfedge>&);
extern template void sort_unique(std::vector<Edge>&);
extern template void sort_unique(std::vector<Face>&);
extern template void sort_unique(std::vector<std::uint32_t>&);

}  // namespace ryosen
