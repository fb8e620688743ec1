#include "core/ops/op.h"

#include <charconv>
#include <cmath>

namespace ryosen {

Text form_of(std::string_view syntax) {
  const std::string form(syntax);
  return form.empty() ? Text{"no argument", "引数なしで"} : Text{form, form + " を"};
}

Text not_understood(std::string_view argument, const Text& expected) {
  const std::string a(argument);
  return {"'" + a + "' is not understood; expected " + expected.en,
          "「" + a + "」は解釈できません。" + expected.ja + "指定してください"};
}

Text argument_missing(std::string_view syntax) {
  const Text expected = form_of(syntax);
  return {"an argument is missing; expected " + expected.en, "引数が足りません。" + expected.ja + "指定してください"};
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
