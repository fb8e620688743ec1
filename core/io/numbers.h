// Reads one number of a text file, the whole token or not at all, whatever the locale.
#pragma once

#include <bit>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <string_view>

namespace ryosen {

enum class NumberRead { finite, non_finite, unreadable };

// The cases that std::from_chars does not settle by itself: a leading plus, overflow and underflow, 1.#INF and kin.
NumberRead read_unusual_real(std::string_view token, double& value);

// Reads a decimal number, rounded to the nearest double. Non-finite are nan and inf in the spellings of C, 1.#IND,
// 1.#INF, 1.#QNAN, 1.#SNAN, and numbers too large for a double. Numbers too small become zero. Anything before or
// after the number makes it unreadable; value is then unspecified.
inline NumberRead read_real(std::string_view token, double& value) {
  const char* const end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, value);
  if (error != std::errc() || stop != end) return read_unusual_real(token, value);
  return std::isfinite(value) ? NumberRead::finite : NumberRead::non_finite;
}

// Reads a whole number. Values beyond 64 bits become the nearest that fits. False if the token is anything else.
bool read_integer(std::string_view token, std::int64_t& value);

// Whether a double holds the whole number exactly, as it does all of up to 53 bits.
template <std::integral Integer>
constexpr bool is_exact_double(Integer value) {
  const auto bits = static_cast<std::uint64_t>(value);
  const std::uint64_t magnitude = value < 0 ? 0 - bits : bits;
  return magnitude == 0 || std::bit_width(magnitude) - std::countr_zero(magnitude) <= 53;
}

}  // namespace ryosen
