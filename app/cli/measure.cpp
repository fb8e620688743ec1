// `measure`: numbers of the elements of a mesh, as the colour maps have them, or between elements that are named.
#include <algorithm>
#include <cmath>

#include "app/cli/columns.h"
#include "app/cli/console.h"
#include "app/cli/contract/json.h"
#include "app/cli/contract/measure.h"
#include "app/cli/subcommand_table.h"
#include "app/editor/commands/command_syntax.h"
#include "app/editor/commands/text/script.h"
#include "app/editor/commands/text/words.h"
#include "app/editor/texts/measure_text.h"
#include "ryosen/analysis/measure/measured_surface.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/io/formats.h"
#include "ryosen/mesh/find_element.h"
#include "ryosen/mesh/names.h"
#include "ryosen/scene/highlights/map_values.h"

namespace ryosen::cli {

namespace {

std::string_view word_of(MapUnit unit) {
  constexpr std::string_view words[] = {"none", "length", "area", "degrees", "per_length", "per_area"};
  return words[static_cast<std::size_t>(unit)];
}

std::string_view word_of(Element::Kind sort) {
  return sort == Element::Kind::vertex ? "vertex" : sort == Element::Kind::edge ? "edge" : "face";
}

// A map of a mesh with what is said of it.
struct Measured {
  const ColourMap& map;
  MapFigures figures;
  std::vector<std::uint32_t> bars;  // from the lowest value to the highest; empty where none are wanted

  double edge(std::size_t i) const {
    return std::lerp(figures.lowest, figures.highest, double(i) / static_cast<double>(bars.size()));
  }
  std::string name_at(const Mesh& mesh, std::uint32_t slot) const {
    Element element;
    element.kind = map.sort();
    element.index = slot;
    return name_of(mesh, element);
  }
};

Measured measured(const Mesh& mesh, const ColourMap& map, std::size_t bars,
                  const std::shared_ptr<const OtherSurface>& other) {
  const MapValues values(mesh, map, 0, other);
  Measured found{map, figures_of(values.all()), {}};
  if (bars > 0 && found.figures.count > 0)
    found.bars = histogram(values.all(), {found.figures.lowest, found.figures.highest}, bars);
  return found;
}

std::string json_line_of(const Measured& found, const Mesh& mesh, const std::string& file) {
  const MapFigures& figures = found.figures;
  const auto number = [&](double value) { return figures.count > 0 ? Json(value) : Json(); };
  const auto name = [&](std::uint32_t slot) { return figures.count > 0 ? Json(found.name_at(mesh, slot)) : Json(); };
  Record<map_shape> json;
  json["file"] = file;
  json["map"] = found.map.id;
  json.put(found.map.name_en, found.map.name_ja);
  json["sort"] = word_of(found.map.sort());
  json["unit"] = word_of(found.map.unit);
  json["count"] = figures.count;
  json["lowest"] = number(figures.lowest);
  json["highest"] = number(figures.highest);
  json["mean"] = number(figures.mean);
  json["deviation"] = number(figures.deviation);
  json["percentile_5"] = number(figures.percentile_5);
  json["quartile_1"] = number(figures.quartile_1);
  json["median"] = number(figures.median);
  json["quartile_3"] = number(figures.quartile_3);
  json["percentile_95"] = number(figures.percentile_95);
  json["lowest_at"] = name(figures.lowest_at);
  json["highest_at"] = name(figures.highest_at);
  json["histogram"] = found.bars.empty() ? Json() : Json::array();
  for (std::size_t i = 0; i < found.bars.size(); ++i) {
    Record<bar_shape> bar;
    bar["low"] = found.edge(i);
    bar["high"] = found.edge(i + 1);
    bar["count"] = found.bars[i];
    json["histogram"].push_back(std::move(bar).json());
  }
  return line_of(json);
}

std::string short_value(double value, MapUnit unit) { return short_number(value) + std::string(sign_of(unit)); }

std::string bars_text(const Measured& found) {
  constexpr double most_signs = 40;
  const std::uint32_t most = *std::max_element(found.bars.begin(), found.bars.end());
  Columns table;
  for (std::size_t i = 0; i < found.bars.size(); ++i)
    table.add({short_value(found.edge(i), found.map.unit), std::to_string(found.bars[i]),
               std::string(static_cast<std::size_t>(std::ceil(most_signs * found.bars[i] / std::max(most, 1u))), '#')});
  return table.text();
}

std::string maps_text(const std::vector<Measured>& all, const Mesh& mesh, const Console& console) {
  Columns table(Columns::Others::figures);
  std::vector<std::string> head{""};
  for (const auto& [en, ja] : std::initializer_list<std::pair<const char*, const char*>>{{"count", "個数"},
                                                                                         {"lowest", "最小"},
                                                                                         {"5 %", "5 %"},
                                                                                         {"median", "中央値"},
                                                                                         {"mean", "平均"},
                                                                                         {"95 %", "95 %"},
                                                                                         {"highest", "最大"},
                                                                                         {"deviation", "標準偏差"},
                                                                                         {"at", "最小の要素"},
                                                                                         {"and", "最大の要素"}})
    head.emplace_back(console.text(en, ja));
  table.add(head);
  for (const Measured& one : all) {
    const MapFigures& f = one.figures;
    std::vector<std::string> row{std::string(console.text(one.map.name_en, one.map.name_ja)), std::to_string(f.count)};
    if (f.count > 0) {
      for (const double value : {f.lowest, f.percentile_5, f.median, f.mean, f.percentile_95, f.highest, f.deviation})
        row.push_back(short_value(value, one.map.unit));
      row.push_back(one.name_at(mesh, f.lowest_at));
      row.push_back(one.name_at(mesh, f.highest_at));
    }
    table.add(row);
  }
  std::string text = table.text();
  for (const Measured& one : all)
    if (!one.bars.empty()) text.append(console.text(one.map.name_en, one.map.name_ja)).append(":\n") += bars_text(one);
  return text;
}

// The maps that --map names, or all; or what is wrong with it.
Result<std::vector<const ColourMap*>> wanted_maps(const Arguments& arguments) {
  std::vector<const ColourMap*> maps;
  const std::string* const id = arguments.value("--map");
  for (const ColourMap& map : colour_maps()) {
    const bool has_other = !map.against || arguments.has("--against");
    if (id && map.id == *id && !has_other)
      return usage_failure("usage", {"That is measured from another mesh: name it by --against.",
                                     "もう一つのメッシュを --against で指定してください。"});
    if (id ? map.id == *id : has_other) maps.push_back(&map);
  }
  if (maps.empty() && find_colour_map(*id)) maps.push_back(find_colour_map(*id));  // of an attribute
  if (!maps.empty()) return maps;
  std::vector<std::string> known;
  for (const ColourMap& map : colour_maps()) known.emplace_back(map.id);
  const Text fault =
      Text{"There is no map '" + *id + "'", "項目「" + *id + "」はありません"} + did_you_mean(*id, known);
  return usage_failure("bad_value", closed(fault));
}

Result<std::size_t> wanted_bars(const Arguments& arguments) {
  const std::string* const words = arguments.value("--bars");
  if (!words) return std::size_t{0};
  if (const auto number = whole_number(*words, 1, 10000)) return std::size_t{*number};
  return usage_failure("bad_value",
                       {"--bars takes a number from 1 to 10000.", "--bars は 1 から 10000 までの数です。"});
}

ExitCode measure_elements(const Mesh& mesh, const std::vector<std::string>& operands, const Console& console) {
  const std::string& path = operands[0];
  std::vector<Element> elements;
  for (const std::string& name : std::span(operands).subspan(1)) {
    NamedElement named = find_element(mesh, name);
    if (!named.element) return console.fail(failure_of_name(named.error, std::move(named.sentence)), path);
    elements.push_back(*named.element);
  }
  const Measurement found = measure(mesh, elements);
  if (found.values.empty())
    return console.fail(make_failure(ExitCode::refused, "refused",
                                     {"There is nothing to measure: name an edge, a face, two elements or three "
                                      "vertices with finite places.",
                                      "計測できません。稜線、面、二つの要素、または三つの頂点（座標が有限のもの）を指定"
                                      "してください。"}),
                        path);
  if (!console.json) return console.end(console.text(text_of(found)) + "\n");
  Record<measurement_shape> json;
  json["file"] = path;
  json["elements"] = Json(std::vector<std::string>(operands.begin() + 1, operands.end()));
  json["values"] = Json::array();
  for (const MeasuredValue& value : found.values) {
    Record<measured_shape> one;
    one.put(value.name);
    one["unit"] = word_of(value.unit);
    one["value"] = value.value;
    json["values"].push_back(std::move(one).json());
  }
  return console.end(line_of(json));
}

}  // namespace

ExitCode measure_command(const Arguments& arguments, const Console& console) {
  const std::string& path = arguments.operands()[0];
  const bool names_elements = arguments.operands().size() > 1;
  if (names_elements && (arguments.has("--map") || arguments.has("--bars") || arguments.has("--against")))
    return console.fail(
        usage_failure("flags_exclude", {"--map, --bars and --against are about all elements, not about named ones.",
                                        "--map、--bars、--against は名前を挙げた要素には使えません。"}));
  const auto maps = wanted_maps(arguments);
  if (!maps) return console.fail(maps.failure());
  const auto bars = wanted_bars(arguments);
  if (!bars) return console.fail(bars.failure());
  std::shared_ptr<const OtherSurface> other;
  if (const std::string* const against = arguments.value("--against")) {
    Result<MeshFile> file = read_mesh_file(*against);
    if (!file) return console.fail(file.failure(), *against);
    for (const Message& message : file->messages) console.show(message, *against);
    other = std::make_shared<const OtherSurface>(from_indexed(std::move(file->mesh)));
  }
  Result<MeshFile> file = read_mesh_file(path);
  if (!file) return console.fail(file.failure(), path);
  for (const Message& message : file->messages) console.show(message, path);
  const Mesh mesh = from_indexed(std::move(file->mesh));
  for (const ColourMap* const map : *maps)
    if (!has_numbers(mesh, *map))
      return console.fail(make_failure(ExitCode::refused, "refused", closed(no_numbers(*map))), path);
  if (names_elements) return measure_elements(mesh, arguments.operands(), console);
  std::vector<Measured> all;
  std::string lines;
  for (const ColourMap* const map : *maps) {
    all.push_back(measured(mesh, *map, *bars, other));
    if (console.json) lines += json_line_of(all.back(), mesh, path);
  }
  return console.end(console.json ? lines : maps_text(all, mesh, console));
}

}  // namespace ryosen::cli
