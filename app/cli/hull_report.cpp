#include "app/cli/hull_report.h"

#include <algorithm>

#include "app/cli/contract/hull.h"
#include "app/cli/contract/json.h"
#include "app/cli/contract/record.h"
#include "app/cli/write_output.h"

namespace ryosen::cli {

namespace {

using Facets = std::vector<std::vector<std::uint32_t>>;

void add_facets(const ConvexHull& hull, Facets& to) {
  for (std::size_t f = 0; f < hull.facet_count(); ++f) to.emplace_back(hull.facet(f).begin(), hull.facet(f).end());
}

template <const Shape& shape>
void put_extent(Record<shape>& json, const HullExtent& extent) {
  json["diameter"] = extent.diameter;
  json["farthest"] = extent.farthest;
  json["width"] = extent.width;
  json["between"] = Json::array();
  if (!extent.between[0].empty()) json["between"] = extent.between;
}

Json component_json(const MadeHull& made, const HullWishes& wishes, bool is_verbose) {
  Record<hull_component_shape> json;
  json["dimension"] = made.hull.dimension;
  json["vertices"] = made.hull.vertices.size();
  json["facets"] = made.hull.facet_count();
  json["volume"] = made.size.volume;
  json["area"] = made.size.area;
  json["used"] = made.hull.used;
  json["points"] = made.points;
  if (is_verbose) {
    Facets facets;
    add_facets(made.hull, facets);
    json["facet_list"] = facets;
    json["extreme"] = made.hull.vertices;
  }
  if (wishes.measure) put_extent(json, made.extent);
  return std::move(json).json();
}

// Of all hulls together.
struct Sums {
  explicit Sums(const std::vector<MadeHull>& hulls) {
    for (const MadeHull& made : hulls) {
      vertices += made.hull.vertices.size();
      facets += made.hull.facet_count();
      used += made.hull.used;
      size.volume += made.size.volume;
      size.area += made.size.area;
    }
  }
  std::size_t vertices = 0, facets = 0, used = 0;
  HullSize size;
};

void put_lists(Record<hull_shape>& json, const std::vector<MadeHull>& hulls) {
  Facets facets;
  std::vector<std::uint32_t> extreme;
  for (const MadeHull& made : hulls) {
    add_facets(made.hull, facets);
    extreme.insert(extreme.end(), made.hull.vertices.begin(), made.hull.vertices.end());
  }
  std::sort(facets.begin(), facets.end());
  std::sort(extreme.begin(), extreme.end());
  json["facet_list"] = facets;
  json["extreme"] = extreme;
}

std::string lines_of_hull(const MadeHull& made, const HullWishes& wishes, const Console& console) {
  std::string text = console.text(hull_sentence(made.hull)) + "\n";
  const auto add = [&](const Text& line) {
    if (!line.en.empty()) text += console.text(line) + "\n";
  };
  add(size_sentence(made.hull, made.size));
  if (wishes.measure) add(extent_sentence(made.extent));
  if (!console.verbose) return text;
  for (std::size_t f = 0; f < made.hull.facet_count(); ++f) {
    for (const std::uint32_t i : made.hull.facet(f)) text += "v" + std::to_string(i) + " ";
    text.back() = '\n';
  }
  return text;
}

Text whole_sentence(const std::vector<MadeHull>& hulls) {
  if (hulls.size() == 1) return hull_sentence(hulls[0].hull);
  const Sums sums(hulls);
  return hulls_sentence(hulls.size(), sums.vertices, sums.facets, sums.size);
}

}  // namespace

int HullReport::dimension() const {
  int largest = -1;
  for (const MadeHull& made : hulls) largest = std::max(largest, made.hull.dimension);
  return largest;
}

std::string HullReport::json_line(ExitCode code, const std::string* output, const Console& console) const {
  const bool warns =
      std::any_of(messages.begin(), messages.end(), [](const Message& m) { return m.severity == Severity::warning; });
  const Sums sums(hulls);
  Record<hull_shape> json;
  json["file"] = input;
  json["output"] = output ? Json(*output) : Json();
  json["status"] = code != ExitCode::done ? "error" : warns ? "warnings" : "ok";
  json["dimension"] = dimension();
  json["vertices"] = sums.vertices;
  json["facets"] = sums.facets;
  json["volume"] = sums.size.volume;
  json["area"] = sums.size.area;
  json["used"] = sums.used;
  json["points"] = points.size();
  if (console.verbose) put_lists(json, hulls);
  if (wishes.per_component) {
    Json& components = json["components"] = Json::array();
    for (const MadeHull& made : hulls) components.push_back(component_json(made, wishes, console.verbose));
  } else if (wishes.measure) {
    put_extent(json, hulls[0].extent);
  }
  json["messages"] = cli::to_json(messages);
  json.put(whole_sentence(hulls));
  return line_of(json);
}

std::string HullReport::text(const std::string* output, const Console& console) const {
  std::string text;
  const bool are_several = hulls.size() != 1;
  if (are_several) text = console.text(whole_sentence(hulls)) + "\n";
  for (const MadeHull& made : hulls) {
    if (are_several) text += "\nv" + std::to_string(made.first) + ": ";
    text += lines_of_hull(made, wishes, console);
  }
  return text + written_text(output, console);
}

}  // namespace ryosen::cli
