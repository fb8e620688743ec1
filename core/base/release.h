// Gives the memory of a list back, which neither clear() nor the assignment of {} does.
#pragma once

#include <vector>

namespace ryosen {

template <class Value>
void release(std::vector<Value>& values) {
  std::vector<Value>().swap(values);
}

}  // namespace ryosen
