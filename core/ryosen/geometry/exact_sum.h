// Exact signs of sums of products of doubles, and of determinants of places as such sums: floating-point expansions for
// ordinary magnitudes, a wide fixed-point accumulator for all others.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>

namespace ryosen::exact {

// Two doubles whose exact sum is the value; `high` is the rounded value.
struct Pair {
  double high;
  double low;
};

// a + b without rounding error. Exact for all finite a, b whose sum does not overflow [Shewchuk97].
inline Pair two_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  const double a_part = sum - b_part;
  return {sum, (a - a_part) + (b - b_part)};
}

// Veltkamp split: the halves of a double, at most 26 significant bits each.
inline Pair split(double a) {
  const double shifted = 134217729.0 * a;  // 2^27 + 1
  const double high = shifted - (shifted - a);
  return {high, a - high};
}

// a * b without rounding error, for magnitudes where neither the product nor its last bit leaves the double range.
inline Pair two_product(double a, double b) {
  const double product = a * b;
  const Pair x = split(a);
  const Pair y = split(b);
  const double rest = product - x.high * y.high - x.low * y.high - x.high * y.low;
  return {product, x.low * y.low - rest};
}

// A sum of doubles as a nonoverlapping expansion, smallest component first. At most Capacity terms may be added.
template <std::size_t Capacity>
class Expansion {
 public:
  void add(double term) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const Pair sum = two_sum(term, terms_[i]);
      term = sum.high;
      if (sum.low != 0.0) terms_[kept++] = sum.low;
    }
    if (term != 0.0) terms_[kept++] = term;
    size_ = kept;
  }

  void add_product(double a, double b) {
    const Pair product = two_product(a, b);
    add(product.low);
    add(product.high);
  }

  void add_product(double a, double b, double c) {
    const Pair product = two_product(a, b);
    if (product.low != 0.0) add_product(product.low, c);
    add_product(product.high, c);
  }

  int sign() const { return size_ == 0 ? 0 : (terms_[size_ - 1] > 0.0 ? 1 : -1); }
  // The sum, right to nearly the last bit.
  double rounded() const {
    double sum = 0;
    for (std::size_t i = 0; i < size_; ++i) sum += terms_[i];
    return sum;
  }

 private:
  std::array<double, Capacity> terms_{};
  std::size_t size_ = 0;
};

// A two's complement fixed-point number that holds exactly the sum of up to 2^60 products of `Factors` finite doubles
// each, and small multiples of it. Its unit is 2^(-1074 Factors), the product of `Factors` smallest doubles.
template <std::size_t Factors>
class ProductSum {
 public:
  void add_product(double a, double b, bool negate) requires(Factors == 2) { add({a, b}, negate); }
  void add_product(double a, double b, double c, bool negate) requires(Factors == 3) { add({a, b, c}, negate); }

  void add(const ProductSum& other) {
    std::uint64_t carry = 0;
    for (std::size_t i = 0; i < limbs_.size(); ++i) {
      const Wide sum = static_cast<Wide>(limbs_[i]) + other.limbs_[i] + carry;
      limbs_[i] = static_cast<std::uint64_t>(sum);
      carry = static_cast<std::uint64_t>(sum >> 64u);
    }
  }

  void multiply(std::uint64_t factor) { multiply(limbs_, factor); }

  int sign() const {
    if (limbs_.back() >> 63u) return -1;
    for (const std::uint64_t limb : limbs_)
      if (limb != 0) return 1;
    return 0;
  }

 private:
  __extension__ using Wide = unsigned __int128;
  using Words = std::array<std::uint64_t, Factors + 1>;  // lowest first; a product plus room for the shift

  struct Parts {
    std::uint64_t mantissa;
    unsigned shift;  // value = mantissa * 2^(shift - 1074)
    bool negative;
  };

  static Parts parts(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    const auto exponent = static_cast<unsigned>((bits >> 52u) & 0x7ffu);
    const std::uint64_t fraction = bits & 0xfffffffffffffu;
    const bool negative = (bits >> 63u) != 0;
    if (exponent == 0) return {fraction, 0, negative};
    return {fraction | 0x10000000000000u, exponent - 1, negative};
  }

  template <class Limbs>
  static void multiply(Limbs& words, std::uint64_t factor) {
    std::uint64_t carry = 0;
    for (std::uint64_t& word : words) {
      const Wide product = static_cast<Wide>(word) * factor + carry;
      word = static_cast<std::uint64_t>(product);
      carry = static_cast<std::uint64_t>(product >> 64u);
    }
  }

  void add(const std::array<double, Factors>& factors, bool negative) {
    Words product{1};
    unsigned shift = 0;
    for (const double factor : factors) {
      const Parts p = parts(factor);
      if (p.mantissa == 0) return;
      multiply(product, p.mantissa);
      shift += p.shift;
      negative ^= p.negative;
    }
    multiply(product, std::uint64_t{1} << shift % 64);
    add_words(product, shift / 64, negative);
  }

  void add_words(const Words& words, std::size_t first, bool negative) {
    std::uint64_t carry = 0;
    for (std::size_t i = first; i < limbs_.size(); ++i) {
      const std::size_t place = i - first;
      if (place >= words.size() && carry == 0) break;
      const Wide word = place < words.size() ? words[place] : 0;
      const Wide changed = negative ? static_cast<Wide>(limbs_[i]) - word - carry : limbs_[i] + word + carry;
      limbs_[i] = static_cast<std::uint64_t>(changed);
      carry = static_cast<std::uint64_t>(changed >> 64u) & 1u;
    }
  }

  // A product of n doubles stays below bit 2098 n; a sum of 2^60 adds 60 bits, a multiple 12, and the sign one.
  std::array<std::uint64_t, (2098 * Factors + 73 + 63) / 64> limbs_{};
};

using ProductAccumulator = ProductSum<2>;

// The determinant of three places, or its opposite.
inline void add_determinant(ProductSum<3>& sum, const glm::dvec3& u, const glm::dvec3& v, const glm::dvec3& w,
                            bool negate = false) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    sum.add_product(u[i], v[j], w[k], negate);
    sum.add_product(u[i], v[k], w[j], !negate);
  }
}

// That of a - d, b - d and c - d, expanded into four of three places each, so that nothing is subtracted.
inline void add_determinant_from(ProductSum<3>& sum, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                                 const glm::dvec3& d) {
  add_determinant(sum, a, b, c);
  add_determinant(sum, b, c, d, true);
  add_determinant(sum, a, c, d);
  add_determinant(sum, a, b, d, true);
}

// A difference of two places without rounding: of each coordinate what it rounds to, and what is missing to it.
using Difference3 = std::array<Pair, 3>;
inline Difference3 difference(const glm::dvec3& p, const glm::dvec3& q) {
  return {two_sum(p.x, -q.x), two_sum(p.y, -q.y), two_sum(p.z, -q.z)};
}

// Adds the product of three pairs, or its opposite. Zero terms are skipped: nearly all low parts are zero.
inline void add_product(Expansion<192>& sum, const Pair& x, const Pair& y, const Pair& z, bool negate) {
  for (const double a : {x.low, x.high}) {
    if (a == 0.0) continue;
    for (const double b : {y.low, y.high}) {
      if (b == 0.0) continue;
      for (const double c : {z.low, z.high})
        if (c != 0.0) sum.add_product(negate ? -a : a, b, c);
    }
  }
}

// The determinant of three differences, of places in whose products nothing over- or underflows.
inline Expansion<192> determinant(const Difference3& u, const Difference3& v, const Difference3& w) {
  Expansion<192> sum;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    add_product(sum, u[i], v[j], w[k], false);
    add_product(sum, u[i], v[k], w[j], true);
  }
  return sum;
}

}  // namespace ryosen::exact
