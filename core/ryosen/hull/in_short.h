// Numbers within sentences.
#pragma once

#include <cstdio>
#include <string>

namespace ryosen::hull {

inline std::string in_short(double value) {
  char number[32];
  std::snprintf(number, sizeof number, "%.9g", value);
  return number;
}

}  // namespace ryosen::hull
