// Frees the memory of a vector, which neither clear() nor assigning {} does.
#pragma once

#include <vector>

namespace ryosen {

template <class Value>
void release(std::vector<Value>& values) {
  std::vector<Value>().swap(values);
}

}  // namespace ryosen
