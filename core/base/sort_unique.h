// Lists in which each value stands once.
#pragma once

#include <algorithm>

namespace ryosen {

// Sorts the values and keeps each once.
template <class Values>
void sort_unique(Values& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

}  // namespace ryosen
