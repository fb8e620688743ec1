// Exact signs of sums of products of doubles: expansions for ordinary magnitudes, a wide accumulator for all others.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

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

// The halves of a double with at most 26 significant bits each.
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

// A sum of doubles kept as a nonoverlapping expansion, smallest component first. Capacity bounds the terms added.
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

  int sign() const { return size_ == 0 ? 0 : (terms_[size_ - 1] > 0.0 ? 1 : -1); }

 private:
  std::array<double, Capacity> terms_{};
  std::size_t size_ = 0;
};

// A two's complement fixed-point number that holds sums of up to sixteen products of two finite doubles exactly: its
// unit is 2^-2148, the square of the smallest double.
class ProductAccumulator {
 public:
  void add_product(double a, double b, bool negate) {
    const Parts x = parts(a);
    const Parts y = parts(b);
    const Wide product = static_cast<Wide>(x.mantissa) * y.mantissa;
    if (product == 0) return;
    add_shifted(product, x.shift + y.shift, (x.negative != y.negative) != negate);
  }

  int sign() const {
    if (limbs_.back() >> 63u) return -1;
    for (const std::uint64_t limb : limbs_) {
      if (limb != 0) return 1;
    }
    return 0;
  }

 private:
  __extension__ using Wide = unsigned __int128;

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

  void add_shifted(Wide value, unsigned shift, bool negative) {
    const std::size_t first = shift / 64;
    const unsigned rest = shift % 64;
    const auto low = static_cast<std::uint64_t>(value);
    const auto high = static_cast<std::uint64_t>(value >> 64u);
    const std::array<std::uint64_t, 3> words = {low << rest, rest == 0 ? high : (high << rest) | (low >> (64 - rest)),
                                                rest == 0 ? 0 : high >> (64 - rest)};
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

  std::array<std::uint64_t, 66> limbs_{};  // 4224 bits: products reach bit 4196, sums of sixteen four bits more
};

}  // namespace ryosen::exact
