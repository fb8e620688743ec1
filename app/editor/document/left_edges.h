// The reasons why an algorithm with a goal left edges.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ryosen {

// Under which rule each edge stands that it left; means nothing after the next change.
struct LeftEdges {
  std::uint64_t serial, revision;   // of the document
  std::vector<std::uint8_t> rules;  // by edge slot, as EdgeRule, or no_rule
  std::vector<std::size_t> counts;  // by rule, counted on points
};

}  // namespace ryosen
