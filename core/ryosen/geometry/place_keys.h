// An order of places for sorting, and a hash for finding those that are equal.
#pragma once

#include <bit>
#include <cstdint>
#include <glm/vec3.hpp>

namespace ryosen {

// By x, then y, then z; of finite places.
inline bool is_before(const glm::dvec3& p, const glm::dvec3& q) {
  return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : p.z < q.z;
}

// Equal for 0 and -0. Every bit depends on all coordinates.
template <class Real>
std::uint32_t hash_of_place(const glm::vec<3, Real>& place) {
  const auto bits = [](Real value) -> std::uint64_t {
    value += Real(0);  // -0 becomes 0
    if constexpr (sizeof(Real) == 4)
      return std::bit_cast<std::uint32_t>(value);
    else
      return std::bit_cast<std::uint64_t>(value);
  };
  std::uint64_t h = bits(place.x) * 0x9e3779b97f4a7c15u;
  h = (h ^ (h >> 32) ^ bits(place.y)) * 0xd6e8feb86659fd93u;
  h = (h ^ (h >> 32) ^ bits(place.z)) * 0xa0761d6478bd642fu;
  return static_cast<std::uint32_t>(h >> 32);
}

}  // namespace ryosen
