#include "ryosen/geometry/single_precision.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>

namespace ryosen {

bool is_decimal_of_single(double value) {
  if (!std::isfinite(value)) return true;
  if (std::abs(value) > static_cast<double>(std::numeric_limits<float>::max())) return false;
  if (to_single(value) == value) return true;
  char text[32];
  char* const end = text + sizeof text;
  const char* stop = std::to_chars(text, end, std::abs(value), std::chars_format::scientific).ptr;
  const std::ptrdiff_t before_exponent = std::find(static_cast<const char*>(text), stop, 'e') - text;
  const auto decimals = static_cast<int>(std::max<std::ptrdiff_t>(before_exponent - 2, 0));
  stop = std::to_chars(text, end, to_single(value), std::chars_format::scientific, decimals).ptr;
  double printed = 0;
  std::from_chars(text, stop, printed);
  return printed == value;
}

}  // namespace ryosen
