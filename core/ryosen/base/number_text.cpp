#include "ryosen/base/number_text.h"

#include <cstdio>

#include <charconv>
#include <cmath>

namespace ryosen {

std::optional<double> parse_double(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

std::string format_double(double value) {
  char buffer[32];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
  static_cast<void>(error);
  return std::string(buffer, end);
}

std::optional<glm::dvec3> parse_place(std::string_view text) {
  glm::dvec3 p{};
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t comma = text.find(',');
    if ((comma == std::string_view::npos) != (axis == 2)) return std::nullopt;
    const auto value = parse_double(text.substr(0, comma));
    if (!value) return std::nullopt;
    p[axis] = *value;
    if (axis < 2) text.remove_prefix(comma + 1);
  }
  return p;
}

std::string format_place(const glm::dvec3& place) {
  return format_double(place.x) + "," + format_double(place.y) + "," + format_double(place.z);
}

std::string hash_text(std::uint64_t hash) {
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
  return digits;
}

}  // namespace ryosen
