#include "ryosen/io/numbers.h"

#include <algorithm>
#include <limits>

namespace ryosen {
namespace {

// Whether a number out of range for from_chars overflows rather than underflows, by the decimal place of its first
// nonzero digit plus the exponent.
bool is_too_large(std::string_view digits) {
  std::int64_t place = 0;
  bool after_point = false, found = false;
  std::size_t i = 0;
  for (; i < digits.size() && (is_digit(digits[i]) || digits[i] == '.'); ++i) {
    if (digits[i] == '.') {
      after_point = true;
      continue;
    }
    found = found || digits[i] != '0';
    if (!after_point && found) ++place;
    if (after_point && !found) --place;
  }
  std::int64_t exponent = 0;
  if (i < digits.size()) read_integer(digits.substr(i + 1), exponent);
  constexpr std::int64_t clear = std::numeric_limits<std::int64_t>::max() / 4;
  if (exponent > clear) return true;
  if (exponent < -clear) return false;
  return place + exponent > 0;
}

// Whether it is this word, in letters of either case, and zeros behind it.
bool is_padded_word(std::string_view text, std::string_view word) {
  return text.size() >= word.size() && text.find_first_not_of('0', word.size()) == std::string_view::npos &&
         std::equal(word.begin(), word.end(), text.begin(), [](char a, char b) { return a == lower_case(b); });
}

}  // namespace

NumberRead read_unusual_real(std::string_view token, double& value) {
  bool negative = false;
  std::string_view digits = token;
  if (!digits.empty() && (digits[0] == '+' || digits[0] == '-')) {
    negative = digits[0] == '-';
    digits.remove_prefix(1);
  }
  if (digits.empty() || digits[0] == '-') return NumberRead::unreadable;
  const double sign = negative ? -1.0 : 1.0;
  // The output of the Windows C library, padded with zeros to the requested precision.
  if (digits.starts_with("1.#")) {
    const std::string_view kind = digits.substr(3);
    const bool infinite = is_padded_word(kind, "inf");
    if (!infinite && !is_padded_word(kind, "ind") && !is_padded_word(kind, "qnan") && !is_padded_word(kind, "snan"))
      return NumberRead::unreadable;
    const double magnitude =
        infinite ? std::numeric_limits<double>::infinity() : std::numeric_limits<double>::quiet_NaN();
    value = std::copysign(magnitude, sign);
    return NumberRead::non_finite;
  }
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value);
  if (stop != end || error == std::errc::invalid_argument) return NumberRead::unreadable;
  if (error == std::errc::result_out_of_range) {
    const bool large = is_too_large(digits);
    value = large ? std::copysign(std::numeric_limits<double>::infinity(), sign) : std::copysign(0.0, sign);
    return large ? NumberRead::non_finite : NumberRead::finite;
  }
  value = std::copysign(value, sign);
  return std::isfinite(value) ? NumberRead::finite : NumberRead::non_finite;
}

bool read_integer(std::string_view token, std::int64_t& value) {
  const bool plus = !token.empty() && token[0] == '+';
  const char* const begin = token.data() + (plus ? 1 : 0);
  const char* const end = token.data() + token.size();
  if (plus && begin != end && *begin == '-') return false;
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (stop != end || error == std::errc::invalid_argument) return false;
  if (error == std::errc::result_out_of_range)
    value = *begin == '-' ? std::numeric_limits<std::int64_t>::min() : std::numeric_limits<std::int64_t>::max();
  return true;
}

}  // namespace ryosen
