#include "app/editor/measure_text.h"

#include <algorithm>
#include <cstdio>

#include "core/mesh/find_element.h"

namespace ryosen {

std::string value_text(double value, MapUnit unit) {
  char digits[40];
  std::snprintf(digits, sizeof digits, "%.9g", value);
  return digits + std::string(sign_of(unit));
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

Text text_of(const ColourMap& map, const MapFigures& figures) {
  const auto value = [&](double v) { return value_text(v, map.unit); };
  const std::string low = value(figures.lowest), high = value(figures.highest), mean = value(figures.mean),
                    median = value(figures.median), count = std::to_string(figures.count);
  return {
      std::string(map.name_en) + ": " + low + " to " + high + ", mean " + mean + ", median " + median + ", of " + count,
      std::string(map.name_ja) + "：" + low + " ～ " + high + "、平均 " + mean + "、中央値 " + median + "、個数 " +
          count};
}

Text measured_text(const Mesh& mesh, std::span<const Element> elements) {
  const bool is_there =
      std::all_of(elements.begin(), elements.end(), [&](const Element& e) { return is_alive(mesh, e); });
  if (!is_there) return {"an element of it is gone", "計測した要素がなくなりました"};
  const Text text = text_of(measure(mesh, elements));
  return text.en.empty() ? Text{"a place is not finite", "座標が有限ではありません"} : text;
}

}  // namespace ryosen
