// A schoolbook integer of any length for tests: the oracle of the exact predicates.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ryosen::test_shapes {

// Sign and magnitude in base 2^16, lowest digit first, without leading zeros.
class BigInteger {
 public:
  BigInteger() = default;

  // The integer value * 2^1074; exact for every finite double.
  static BigInteger scaled(double value) {
    BigInteger result;
    result.negative_ = std::signbit(value);
    int exponent = 0;
    const double fraction = std::frexp(std::abs(value), &exponent);
    auto mantissa = static_cast<std::uint64_t>(std::ldexp(fraction, 53));
    int shift = exponent - 53 + 1074;
    for (; shift < 0; ++shift) mantissa >>= 1;  // only zero bits go: denormals
    result.digits_.assign(static_cast<std::size_t>(shift) / 16, 0);
    std::uint64_t carry = 0;
    for (; mantissa != 0 || carry != 0; mantissa >>= 16) {
      const std::uint64_t digit = ((mantissa & 0xffffu) << (shift % 16)) + carry;
      result.digits_.push_back(static_cast<std::uint16_t>(digit));
      carry = digit >> 16;
    }
    result.trim();
    return result;
  }

  int sign() const { return digits_.empty() ? 0 : (negative_ ? -1 : 1); }

  friend BigInteger operator-(BigInteger a) {
    a.negative_ = !a.negative_;
    return a;
  }

  friend BigInteger operator+(const BigInteger& a, const BigInteger& b) {
    BigInteger result;
    if (a.negative_ == b.negative_) {
      result.negative_ = a.negative_;
      result.digits_ = add(a.digits_, b.digits_);
    } else if (is_smaller(a.digits_, b.digits_)) {
      result.negative_ = b.negative_;
      result.digits_ = subtract(b.digits_, a.digits_);
    } else {
      result.negative_ = a.negative_;
      result.digits_ = subtract(a.digits_, b.digits_);
    }
    result.trim();
    return result;
  }

  friend BigInteger operator-(const BigInteger& a, const BigInteger& b) { return a + (-b); }

  friend BigInteger operator*(const BigInteger& a, const BigInteger& b) {
    BigInteger result;
    result.negative_ = a.negative_ != b.negative_;
    result.digits_.assign(a.digits_.size() + b.digits_.size(), 0);
    for (std::size_t i = 0; i < a.digits_.size(); ++i) {
      std::uint32_t carry = 0;
      for (std::size_t j = 0; j < b.digits_.size() || carry != 0; ++j) {
        const std::uint32_t factor = j < b.digits_.size() ? b.digits_[j] : 0;
        const std::uint32_t digit = result.digits_[i + j] + a.digits_[i] * factor + carry;
        result.digits_[i + j] = static_cast<std::uint16_t>(digit);
        carry = digit >> 16;
      }
    }
    result.trim();
    return result;
  }

 private:
  using Digits = std::vector<std::uint16_t>;

  static bool is_smaller(const Digits& a, const Digits& b) {
    if (a.size() != b.size()) return a.size() < b.size();
    return std::lexicographical_compare(a.rbegin(), a.rend(), b.rbegin(), b.rend());
  }

  static Digits add(const Digits& a, const Digits& b) {
    Digits result;
    std::uint32_t carry = 0;
    for (std::size_t i = 0; i < a.size() || i < b.size() || carry != 0; ++i) {
      const std::uint32_t digit = (i < a.size() ? a[i] : 0u) + (i < b.size() ? b[i] : 0u) + carry;
      result.push_back(static_cast<std::uint16_t>(digit));
      carry = digit >> 16;
    }
    return result;
  }

  static Digits subtract(const Digits& a, const Digits& b) {
    Digits result;
    std::int32_t borrow = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      std::int32_t digit = a[i] - (i < b.size() ? b[i] : 0) - borrow;
      borrow = digit < 0 ? 1 : 0;
      if (digit < 0) digit += 0x10000;
      result.push_back(static_cast<std::uint16_t>(digit));
    }
    return result;
  }

  void trim() {
    while (!digits_.empty() && digits_.back() == 0) digits_.pop_back();
  }

  Digits digits_;
  bool negative_ = false;
};

}  // namespace ryosen::test_shapes
