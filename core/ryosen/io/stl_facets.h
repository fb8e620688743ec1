// The facets of a binary STL file, and welding of corners at equal positions, which STL stores one by one.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <glm/vec3.hpp>
#include <vector>

#include "ryosen/base/column_memory.h"
#include "ryosen/geometry/place_keys.h"
#include "ryosen/io/stl.h"

namespace ryosen {

// A hash table by position, for finding coincident points: the number of the first item at each. Open addressing; O(1)
// expected; 8 bytes per slot, load factor at most 2/3.
class PlaceTable {
 public:
  // A mesh has about a sixth as many vertices as corners.
  explicit PlaceTable(std::size_t expected_corners) {
    std::size_t size = 64;
    while (size < expected_corners / 4) size *= 2;
    slots_.assign(size, empty);
  }

  // The item stored at a position; if there is none, stores and returns `number`. is_here(n) tells whether a stored
  // item with the same hash is really at that position.
  template <class IsHere>
  std::uint32_t first(std::uint32_t hash, std::uint32_t number, IsHere is_here) {
    if (stored_ * 3 >= slots_.size() * 2) grow();
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t at = hash & mask;; at = (at + 1) & mask) {
      const std::uint64_t slot = slots_[at];
      if (slot == empty) {
        slots_[at] = std::uint64_t{hash} << 32 | number;
        ++stored_;
        return number;
      }
      const auto stored = static_cast<std::uint32_t>(slot);
      if (slot >> 32 == hash && is_here(stored)) return stored;
    }
  }

  // Prefetches the slot that first() will probe for this hash.
  void prefetch(std::uint32_t hash) const { __builtin_prefetch(&slots_[hash & (slots_.size() - 1)]); }

 private:
  // A slot holds the hash in its upper half and the number in the lower.
  static constexpr std::uint64_t empty = ~std::uint64_t{0};

  void grow() {
    UnwrittenVector<std::uint64_t> old(2 * slots_.size(), empty);
    old.swap(slots_);
    const std::size_t mask = slots_.size() - 1;
    for (const std::uint64_t slot : old) {
      if (slot == empty) continue;
      std::size_t at = (slot >> 32) & mask;
      while (slots_[at] != empty) at = (at + 1) & mask;
      slots_[at] = slot;
    }
  }

  UnwrittenVector<std::uint64_t> slots_;  // size is a power of two
  std::size_t stored_ = 0;
};

// Welds corners at equal positions: numbers distinct positions in order of first occurrence. -0 equals 0, and a
// position with a NaN equals none, not even itself; the first corner gives the coordinates. O(1) expected per corner.
class Welder {
 public:
  // Positions are added to `positions`, which must outlive the welder and be empty.
  Welder(std::vector<glm::dvec3>& positions, std::size_t expected_corners)
      : positions_(positions), table_(expected_corners) {
    positions_.reserve(expected_corners / 6);
  }

  // The number of a position.
  std::uint32_t number(const glm::dvec3& p) {
    const auto next = static_cast<std::uint32_t>(positions_.size());
    const std::uint32_t first =
        p == p ? table_.first(hash_of_place(p), next, [&](std::uint32_t stored) { return positions_[stored] == p; })
               : next;
    if (first == next) positions_.push_back(p);
    return first;
  }

 private:
  std::vector<glm::dvec3>& positions_;
  PlaceTable table_;
};

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
