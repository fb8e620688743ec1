// Axis-aligned bounding boxes of floats in SIMD registers (fourth lane unused), and outward rounding into them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <glm/vec3.hpp>
#include <limits>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace ryosen {

#if defined(__SSE2__)

// Four floats. smaller and larger return the second operand if either is NaN.
struct Float4 {
  __m128 lanes;

  static Float4 of(float x, float y, float z, float w) { return {_mm_setr_ps(x, y, z, w)}; }
  static Float4 all(float x) { return {_mm_set1_ps(x)}; }
  static Float4 load(const void* four) { return {_mm_loadu_ps(static_cast<const float*>(four))}; }
  void store(float* four) const { _mm_storeu_ps(four, lanes); }
  float first() const { return _mm_cvtss_f32(lanes); }
  // Lane 1 (or lane 2) moved to lane 0; the other lanes do not matter.
  Float4 second_first() const { return {_mm_shuffle_ps(lanes, lanes, _MM_SHUFFLE(3, 2, 1, 1))}; }
  Float4 third_first() const { return {_mm_shuffle_ps(lanes, lanes, _MM_SHUFFLE(3, 2, 1, 2))}; }
  friend Float4 operator+(Float4 a, Float4 b) { return {_mm_add_ps(a.lanes, b.lanes)}; }
  friend Float4 operator-(Float4 a, Float4 b) { return {_mm_sub_ps(a.lanes, b.lanes)}; }
  friend Float4 operator*(Float4 a, Float4 b) { return {_mm_mul_ps(a.lanes, b.lanes)}; }
  friend Float4 smaller(Float4 a, Float4 b) { return {_mm_min_ps(a.lanes, b.lanes)}; }
  friend Float4 larger(Float4 a, Float4 b) { return {_mm_max_ps(a.lanes, b.lanes)}; }
};

#else

struct Float4 {
  std::array<float, 4> lanes;

  static Float4 of(float x, float y, float z, float w) { return {{x, y, z, w}}; }
  static Float4 all(float x) { return {{x, x, x, x}}; }
  static Float4 load(const void* four) {
    Float4 r;
    std::memcpy(&r, four, sizeof r);
    return r;
  }
  void store(float* four) const { std::copy(lanes.begin(), lanes.end(), four); }
  float first() const { return lanes[0]; }
  Float4 second_first() const { return {{lanes[1], lanes[1], lanes[2], lanes[3]}}; }
  Float4 third_first() const { return {{lanes[2], lanes[1], lanes[2], lanes[3]}}; }
  template <class Function>
  static Float4 each(const Float4& a, const Float4& b, Function f) {
    Float4 r;
    for (std::size_t i = 0; i < 4; ++i) r.lanes[i] = f(a.lanes[i], b.lanes[i]);
    return r;
  }
  friend Float4 operator+(Float4 a, Float4 b) {
    return each(a, b, [](float x, float y) { return x + y; });
  }
  friend Float4 operator-(Float4 a, Float4 b) {
    return each(a, b, [](float x, float y) { return x - y; });
  }
  friend Float4 operator*(Float4 a, Float4 b) {
    return each(a, b, [](float x, float y) { return x * y; });
  }
  friend Float4 smaller(Float4 a, Float4 b) {
    return each(a, b, [](float x, float y) { return x < y ? x : y; });
  }
  friend Float4 larger(Float4 a, Float4 b) {
    return each(a, b, [](float x, float y) { return x > y ? x : y; });
  }
};

#endif

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
