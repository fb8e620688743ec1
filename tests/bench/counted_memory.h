// How much memory the program has taken through operator new: the largest amount at once since the last reset.
#pragma once

#include <cstddef>

namespace ryosen::bench {

std::size_t allocated_now();
std::size_t allocated_peak();
void reset_allocated_peak();

}  // namespace ryosen::bench
