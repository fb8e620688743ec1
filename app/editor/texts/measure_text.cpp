#include "app/editor/texts/measure_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "app/editor/commands/text/words.h"
#include "ryosen/mesh/find_element.h"
#include "ryosen/mesh/names.h"

namespace ryosen {

std::string value_text(double value, MapUnit unit) {
  char digits[40];
  std::snprintf(digits, sizeof digits, "%.9g", value);
  return digits + std::string(sign_of(unit));
}

std::vector<std::string> numbers_alike(std::span<const double> values) {
  std::vector<std::string> texts;
  char text[400];
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  if (values.empty() || !(*most - *least > 0) || !std::isfinite(*most - *least)) {
    for (const double value : values) {
      std::snprintf(text, sizeof text, "%.6g", value);
      texts.push_back(text);
    }
    return texts;
  }
  const auto power = [](double value) { return static_cast<int>(std::floor(std::log10(value))); };
  const int size = power(std::max(std::abs(*least), std::abs(*most)));
  const bool has_power = size < -3 || size > 6;
  const double unit = has_power ? std::pow(10.0, size) : 1;
  int digits = std::clamp(3 - power(*most - *least) + (has_power ? size : 0), 0, 15);
  for (const double value : values) {
    std::snprintf(text, sizeof text, "%.*f", digits, value / unit + 0.0);
    texts.push_back(text);
  }
  const auto ends_in_zero = [](const std::string& each) { return each.back() == '0'; };
  for (; digits > 0 && std::all_of(texts.begin(), texts.end(), ends_in_zero); --digits)
    for (std::string& each : texts) each.pop_back();
  for (std::string& each : texts) {
    if (each.back() == '.') each.pop_back();
    if (has_power && each != "0") each += "e" + std::to_string(size);
  }
  return texts;
}

std::vector<std::string> numbers_of(const ColourMap& map, std::span<const double> values) {
  std::vector<std::string> numbers = numbers_alike(values);
  if (!map.is_count) return numbers;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (values[i] == std::round(values[i])) numbers[i] = std::to_string(std::llround(values[i]));
  return numbers;
}

std::vector<double> legend_values(const ColourMap& map, MapRange range, std::size_t most) {
  const MapRange whole{std::ceil(range.low), std::floor(range.high)};
  const bool is_count = map.is_count && whole.low <= whole.high;
  const auto [low, high] = is_count ? whole : range;
  std::vector<double> values;
  const double widest = static_cast<double>(most) - 1;
  const double parts = !(low < high) ? 0 : is_count ? std::min(widest, high - low) : widest;
  for (double i = 0; i <= parts; ++i) {
    const double value = std::lerp(low, high, i / std::max(parts, 1.0));
    values.push_back(is_count ? std::round(value) : value);
  }
  return values;
}

Text text_of(const Measurement& found) {
  Text text;
  for (const MeasuredValue& each : found.values) {
    const std::string value = value_text(each.value, each.unit);
    text.en += (text.en.empty() ? "" : ", ") + each.name.en + " " + value;
    text.ja += (text.ja.empty() ? "" : "、") + each.name.ja + " " + value;
  }
  return text;
}

namespace {

// The lowest value, the highest, the mean and the median, as they are written.
Text figures_text(const ColourMap& map, const MapFigures& figures, std::span<const std::string> values) {
  const std::string &low = values[0], &high = values[1], &mean = values[2], &median = values[3];
  const std::string count = std::to_string(figures.count);
  return {
      std::string(map.name_en) + ": " + low + " to " + high + ", mean " + mean + ", median " + median + ", of " + count,
      std::string(map.name_ja) + "：" + low + " ～ " + high + "、平均 " + mean + "、中央値 " + median + "、個数 " +
          count};
}

}  // namespace

Text text_of(const ColourMap& map, const MapFigures& figures) {
  std::vector<std::string> values;
  for (const double value : {figures.lowest, figures.highest, figures.mean, figures.median})
    values.push_back(value_text(value, map.unit));
  return figures_text(map, figures, values);
}

Text short_text_of(const ColourMap& map, const MapFigures& figures) {
  std::vector<std::string> values =
      numbers_of(map, std::array{figures.lowest, figures.highest, figures.mean, figures.median});
  for (std::string& value : values) value += sign_of(map.unit);
  return figures_text(map, figures, values);
}

Text short_text_of(const Measurement& found) {
  const Text text = text_of(found);
  return {with_short_numbers(text.en), with_short_numbers(text.ja)};
}

std::string names_of_measured(const Mesh& mesh, std::span<const Element> elements) {
  constexpr std::size_t most = 3;  // as measurements between elements have
  std::string names;
  for (const Element& e : elements.first(std::min(elements.size(), most)))
    names += (names.empty() ? "" : " ") + name_of(mesh, e);
  if (elements.size() > most) names += " +" + std::to_string(elements.size() - most);
  return names;
}

Text measured_text(const Mesh& mesh, std::span<const Element> elements) {
  const bool is_there =
      std::all_of(elements.begin(), elements.end(), [&](const Element& e) { return is_alive(mesh, e); });
  if (!is_there) return {"an element of it is gone", "計測した要素がなくなりました"};
  const Text text = short_text_of(measure(mesh, elements));
  return text.en.empty() ? Text{"a place is not finite", "座標が有限ではありません"} : text;
}

}  // namespace ryosen
