// Axis-aligned bounding boxes of floats in vector registers (fourth lane unused), and outward rounding into them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <glm/vec3.hpp>
#include <limits>

namespace ryosen {

// Four floats in a vector register. smaller and larger return the second operand if either is NaN.
struct Float4 {
  using Lanes [[gnu::vector_size(16)]] = float;
  Lanes lanes;

  static Float4 of(float x, float y, float z, float w) { return {Lanes{x, y, z, w}}; }
  static Float4 all(float x) { return of(x, x, x, x); }
  static Float4 load(const void* four) {
    Float4 loaded;
    std::memcpy(&loaded.lanes, four, sizeof loaded.lanes);
    return loaded;
  }
  void store(float* four) const { std::memcpy(four, &lanes, sizeof lanes); }
  float first() const { return lanes[0]; }
  // Lane 1 (or lane 2) moved to lane 0; the other lanes do not matter.
  Float4 second_first() const { return {__builtin_shufflevector(lanes, lanes, 1, 1, 2, 3)}; }
  Float4 third_first() const { return {__builtin_shufflevector(lanes, lanes, 2, 1, 2, 3)}; }
  friend Float4 operator+(Float4 a, Float4 b) { return {a.lanes + b.lanes}; }
  friend Float4 operator-(Float4 a, Float4 b) { return {a.lanes - b.lanes}; }
  friend Float4 operator*(Float4 a, Float4 b) { return {a.lanes * b.lanes}; }
  friend Float4 smaller(Float4 a, Float4 b) { return {a.lanes < b.lanes ? a.lanes : b.lanes}; }
  friend Float4 larger(Float4 a, Float4 b) { return {a.lanes > b.lanes ? a.lanes : b.lanes}; }
};

inline std::array<float, 4> floats_of(Float4 v) {
  std::array<float, 4> result;
  v.store(result.data());
  return result;
}

// Over the lanes 0, 1, 2.
inline float smallest_of_three(Float4 v) { return smaller(smaller(v, v.second_first()), v.third_first()).first(); }
inline float largest_of_three(Float4 v) { return larger(larger(v, v.second_first()), v.third_first()).first(); }

struct FloatBox {
  Float4 lowest;
  Float4 highest;
};

inline FloatBox empty_box() {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  return {Float4::all(infinity), Float4::all(-infinity)};
}

inline void grow(FloatBox& box, const FloatBox& other) {
  box.lowest = smaller(box.lowest, other.lowest);
  box.highest = larger(box.highest, other.highest);
}

inline FloatBox united(FloatBox a, const FloatBox& b) {
  grow(a, b);
  return a;
}

// Half the surface area: proportional to the probability that a random ray hits the box.
inline float half_area(const FloatBox& box) {
  const std::array<float, 4> size = floats_of(box.highest - box.lowest);
  return size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
}

inline float largest_magnitude(const FloatBox& box) {
  return std::max(largest_of_three(box.highest), -smallest_of_three(box.lowest));
}

inline bool is_same(const FloatBox& a, const FloatBox& b) {
  const std::array<float, 4> a_low = floats_of(a.lowest), a_high = floats_of(a.highest);
  const std::array<float, 4> b_low = floats_of(b.lowest), b_high = floats_of(b.highest);
  return std::equal(a_low.begin(), a_low.begin() + 3, b_low.begin()) &&
         std::equal(a_high.begin(), a_high.begin() + 3, b_high.begin());
}

// Floats strictly outside two doubles of magnitude below 1e38, by about two units in the last place. The margin is
// taken in double, before the one rounding, so nothing depends on what a compiler does with a round trip.
inline float float_below(double value) { return static_cast<float>(value - (std::abs(value) * 0x1p-22 + 1e-37)); }
inline float float_above(double value) { return static_cast<float>(value + (std::abs(value) * 0x1p-22 + 1e-37)); }

inline FloatBox rounded_outwards(const glm::dvec3& lowest, const glm::dvec3& highest) {
  return {Float4::of(float_below(lowest.x), float_below(lowest.y), float_below(lowest.z), 0.0f),
          Float4::of(float_above(highest.x), float_above(highest.y), float_above(highest.z), 0.0f)};
}

}  // namespace ryosen
