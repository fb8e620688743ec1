// The facets of a binary STL file, and welding of their corners.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <glm/vec3.hpp>
#include <vector>

#include "ryosen/io/stl.h"

namespace ryosen {

// Reads a little-endian number, unaligned.
template <class Number>
Number load_little(const char* at) {
  unsigned char bytes[sizeof(Number)];
  std::memcpy(bytes, at, sizeof bytes);
  if constexpr (std::endian::native == std::endian::big) std::reverse(bytes, bytes + sizeof bytes);
  Number number;
  std::memcpy(&number, bytes, sizeof number);
  return number;
}

// A view of consecutive facets: a normal, three corners, an attribute. 3 * count < 2^32.
class StlFacets {
 public:
  StlFacets(const char* first, std::uint32_t count) : first_(first), count_(count) {}

  std::uint32_t count() const { return count_; }
  std::uint32_t corners() const { return 3 * count_; }
  // Corner c % 3 of facet c / 3.
  glm::vec3 place(std::uint32_t c) const {
    const char* const at = at_corner(c);
    return {load_little<float>(at), load_little<float>(at + 4), load_little<float>(at + 8)};
  }
  const char* at_corner(std::uint32_t c) const {
    return first_ + std::size_t{c / 3} * stl_facet_bytes + 12 * (c % 3 + std::size_t{1});
  }
  std::uint16_t attribute(std::uint32_t facet) const {
    return load_little<std::uint16_t>(first_ + (facet + std::size_t{1}) * stl_facet_bytes - 2);
  }

 private:
  const char* first_;
  std::uint32_t count_;
};

struct StlFacetFindings {
  bool all_finite = true;       // the places
  bool has_attributes = false;  // some attribute is not zero
};

// Assigns each corner the number of its distinct position, with the numbering of Welder, and fills `positions`, which
// must be empty. Deterministic for any number of threads: each handles a share of the hash values, and positions are
// numbered by first corner. O(1) expected per corner; 16 bytes per corner of temporary memory.
StlFacetFindings weld_facets(const StlFacets& facets, unsigned threads, std::vector<glm::dvec3>& positions,
                             std::vector<std::uint32_t>& corners);

}  // namespace ryosen
