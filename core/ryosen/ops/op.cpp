#include "ryosen/ops/op.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace ryosen {

double OpTarget::snapped_along() const {
  constexpr double near_middle = 0.08;
  const double parts = is_free ? 1000 : 10;
  if (!is_free && std::abs(along - 0.5) < near_middle) return 0.5;
  return std::clamp(std::round(along * parts), 1.0, parts - 1) / parts;
}

Text not_understood(std::string_view argument, const Text& expected) {
  const std::string a(argument);
  return {"'" + a + "' is not understood; expected " + expected.en,
          "「" + a + "」は解釈できません。" + expected.ja + "指定してください"};
}

Text not_of_syntax(std::string_view argument, std::string_view syntax) {
  const std::string a(argument), expected(syntax);
  if (!expected.empty()) return not_understood(argument, {expected, expected + " を"});
  return {"'" + a + "' is not understood; expected no argument", "「" + a + "」は解釈できません。引数は付けられません"};
}

Text argument_missing(std::string_view syntax) {
  const std::string expected(syntax);
  return {"an argument is missing; expected " + expected, "引数が足りません。" + expected + " を指定してください"};
}

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

}  // namespace ryosen
