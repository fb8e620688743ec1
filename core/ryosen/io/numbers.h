// Locale-independent parsing of numbers: the whole token or not at all.
#pragma once

#include <bit>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <string_view>

namespace ryosen {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
// Of the letters of ASCII.
constexpr char lower_case(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

enum class NumberRead { finite, non_finite, unreadable };

// The cases that std::from_chars does not handle: a leading plus, overflow and underflow, 1.#INF etc.
NumberRead read_unusual_real(std::string_view token, double& value);

// Parses a decimal number, rounded to the nearest double. Non-finite: nan and inf in the spellings of C, 1.#IND,
// 1.#INF, 1.#QNAN, 1.#SNAN, and overflow. Underflow gives zero. Extra characters make it unreadable; value is then
// unspecified.
inline NumberRead read_real(std::string_view token, double& value) {
  const char* const end = token.data() + token.size();
  const auto [stop, error] = std::from_chars(token.data(), end, value);
  if (error != std::errc() || stop != end) return read_unusual_real(token, value);
  return std::isfinite(value) ? NumberRead::finite : NumberRead::non_finite;
}

// Parses an integer; saturates at 64 bits. False if the token is anything else.
bool read_integer(std::string_view token, std::int64_t& value);

// Whether the integer is exactly representable as a double.
template <std::integral Integer>
constexpr bool is_exact_double(Integer value) {
  const auto bits = static_cast<std::uint64_t>(value);
  const std::uint64_t magnitude = value < 0 ? 0 - bits : bits;
  return magnitude == 0 || std::bit_width(magnitude) - std::countr_zero(magnitude) <= 53;
}

}  // namespace ryosen
