// A list as flags and parameters take it: parts with commas, or another separator, between them.
#pragma once

#include <algorithm>
#include <string_view>
#include <vector>

namespace ryosen {

// Empty parts too.
inline std::vector<std::string_view> split_list(std::string_view list, char separator = ',') {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(separator, begin), list.size());
    parts.push_back(list.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

}  // namespace ryosen
