#include <algorithm>

#include "app/editor/camera/view_state.h"
#include "app/editor/document/findings.h"
#include "app/editor/labels/labels.h"
#include "app/editor/preferences/preference_values.h"
#include "app/editor/session/selecting.h"
#include "app/editor/texts/measure_text.h"
#include "ryosen/analysis/measures.h"
#include "ryosen/mesh/face_polygon.h"
#include "ryosen/mesh/find_element.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

void add_measures(const Mesh& mesh, const Selecting& selecting, const Preferences& preferences,
                  std::vector<Label>& labels) {
  constexpr std::size_t most = 3;  // of more there is no place where it was measured
  for (const Elements& measured : selecting.measures) {
    bool is_there = measured.size() <= most;
    for (const Element& e : measured) is_there = is_there && is_alive(mesh, e);
    if (!is_there || measured.empty()) continue;
    const Measurement found = measure(mesh, measured);
    if (found.values.empty()) continue;
    const bool has_way = found.path.size() > 1;
    Label label{.at = has_way ? 0.5 * found.path[0] + 0.5 * found.path[1] : middle_of(mesh, measured.front()),
                .text = short_text_of(found).in(preferences.language),
                .priority = measure_priority,
                .moves_aside = true,
                .through = true};
    labels.push_back(std::move(label));
  }
}

void add_map_legend(Findings& findings, const ViewState& view, const Preferences& preferences,
                    std::vector<Label>& labels) {
  constexpr double row_px = 17, margin_px = 12, width_px = 84;
  const auto [map, range] = *view.colouring;
  const MapRange extent = findings.map_extent(*view.colouring);
  const glm::dvec2 corner(0, view.size.height);
  const auto add = [&](int row, std::string text, std::optional<std::uint32_t> ground) {
    labels.push_back({.text = std::move(text),
                      .priority = legend_priority,
                      .shift_px = {margin_px, -margin_px - (row + 0.5) * row_px},
                      .pixel = corner,
                      .begins_there = true,
                      .least_width_px = ground ? width_px : 0,
                      .ground = ground});
  };
  const std::vector<double> values = legend_values(*map, range, 7);
  const std::vector<std::string> numbers = numbers_of(*map, values);
  const int steps = static_cast<int>(values.size());
  for (int i = 0; i < steps; ++i) {
    const double value = values[i];
    const bool is_more = i == 0 ? extent.low < range.low : i == steps - 1 && extent.high > range.high;
    const std::string sign = is_more ? (i == 0 ? "< " : "> ") : "";
    add(i, sign + numbers[i] + std::string(sign_of(map->unit)),
        colour_at(map->scale, place_on_scale(*map, range, value)));
  }
  add(steps, std::string(preferences.language == Language::japanese ? map->name_ja : map->name_en), std::nullopt);
}

}  // namespace ryosen
