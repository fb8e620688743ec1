// Sorting with removal of duplicates.
#pragma once

#include <algorithm>

namespace ryosen {

// Sorts the values and removes duplicates.
template <class Values>
void sort_unique(Values& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

}  // namespace ryosen
