// An algorithm that the program does not have, with one parameter of each kind: its row must be all that anybody needs.
#pragma once

#include "ryosen/algo/algorithm.h"

namespace ryosen::test {

// Puts `copies` free vertices at x = number, y = distance, z = half the ratio, half a turn about z where the angle is
// 180, lifted by how many elements were named, all of it moved by the place; the flag and the choice negate x and y.
inline AlgorithmResult run_scatter(Edit& edit, const AlgorithmInput& input, Progress& progress) {
  const ParameterValues& values = input.values;
  const double turn = values.angle_rad("angle") > 3 ? -1 : 1, lift = static_cast<double>(values.elements("at").size());
  const glm::dvec3 place{turn * values.number("x") * (values.flag("mirror") ? -1 : 1),
                         turn * values.length("distance") * (values.choice("way") == "down" ? -1 : 1),
                         values.ratio("share") / 2 + lift};
  const glm::dvec3 moved = place + values.place("by");
  for (std::size_t i = 0; i < values.count("copies"); ++i) {
    if (!progress.go_on(i, values.count("copies"))) return {};
    edit.fresh(edit.add_vertex(moved));
  }
  const std::string n = std::to_string(values.count("copies"));
  return {values.count("copies"), 0, {n + " put.", n + " 個置きました。"}};
}

inline AlgorithmRow scatter_row() {
  using Kind = ParameterKind;
  const auto row = [](std::string_view id, Kind kind, std::string_view initial) {
    return ParameterRow{.id = id,
                        .kind = kind,
                        .name_en = id,
                        .name_ja = "値",
                        .help_en = "a value to try",
                        .help_ja = "試すための値",
                        .initial = initial};
  };
  AlgorithmRow scatter{"scatter", "Scatter", "散布", "puts free vertices", "孤立頂点を置く", {}, true, {}, run_scatter};
  scatter.parameters = {
      row("distance", Kind::length, ""), row("x", Kind::number, "0"),      row("copies", Kind::count, "1"),
      row("share", Kind::ratio, "0.5"),  row("angle", Kind::angle, "0"),   row("by", Kind::place, "0,0,0"),
      row("way", Kind::choice, "up"),    row("mirror", Kind::flag, "off"), row("at", Kind::elements, "")};
  scatter.parameters[0].is_required = true;
  scatter.parameters[1].smallest = -5;
  scatter.parameters[1].excludes_smallest = true;
  scatter.parameters[1].largest = 5;
  scatter.parameters[2].smallest = 1;
  scatter.parameters[2].unit_en = "vertices";
  scatter.parameters[2].unit_ja = "個";
  scatter.parameters[6].choices = {{"up", "Up", "上"}, {"down", "Down", "下"}};
  scatter.parameters[8].is_required = true;
  return scatter;
}

}  // namespace ryosen::test
