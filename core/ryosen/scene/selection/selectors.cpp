#include "ryosen/scene/selection/selectors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "ryosen/analysis/components.h"
#include "ryosen/analysis/measures.h"
#include "ryosen/base/index_set.h"
#include "ryosen/base/number_text.h"
#include "ryosen/base/open_table.h"
#include "ryosen/base/rows.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/scene/highlights/feature_edges.h"
#include "ryosen/scene/highlights/map_values.h"
#include "ryosen/scene/selection/derived_selections.h"

namespace ryosen {

namespace {

using Selected = std::span<const Element>;

bool counts(const Mesh& mesh, Vertex v) { return mesh.is_alive(v) && point(mesh, v) == v; }
template <class Handle>
bool counts(const Mesh& mesh, Handle element) {
  return mesh.is_alive(element);
}

// The live elements of a kind, points in place of vertices, that are so; ascending.
template <class Handle, class Is>
Elements those(const Mesh& mesh, Is is) {
  Elements found;
  for (Handle element(0); mesh.exists(element); ++element.index)
    if (counts(mesh, element) && is(element)) found.emplace_back(element);
  return found;
}
template <class Is>
Elements those(const Mesh& mesh, Element::Kind sort, Is is) {
  return Element(sort).visit([&](auto none) { return those<decltype(none)>(mesh, is); });
}

Elements find_none(const Mesh&, Selected, Element::Kind, ValueRange) { return {}; }

Elements find_all(const Mesh& mesh, Selected, Element::Kind sort, ValueRange) {
  return those(mesh, sort, [](auto) { return true; });
}

// Of each kind that is selected, all others.
Elements find_others(const Mesh& mesh, Selected selection, Element::Kind sort, ValueRange) {
  ElementSet selected(selection);
  for (const Element& e : selection)  // a copy stands for its point
    if (e.kind == Element::Kind::vertex) selected.insert(point(mesh, e.vertex()));
  Elements others;
  for (const Element::Kind kind :
       {Element::Kind::vertex, Element::Kind::halfedge, Element::Kind::edge, Element::Kind::face}) {
    const auto is_of_kind = [&](const Element& e) { return e.kind == kind; };
    if (selection.empty() ? kind != sort : std::none_of(selection.begin(), selection.end(), is_of_kind)) continue;
    const Elements found = those(mesh, kind, [&](auto element) { return !selected.contains(element); });
    others.insert(others.end(), found.begin(), found.end());
  }
  return others;
}

Elements of_valence(const Mesh& mesh, Selected, Element::Kind, ValueRange value) {
  return those<Vertex>(mesh, [&](Vertex v) { return value.holds(valence(mesh, v)); });
}
Elements of_sides(const Mesh& mesh, Selected, Element::Kind, ValueRange value) {
  return those<Face>(mesh, [&](Face f) { return value.holds(corner_count(mesh, f)); });
}

// The faces of parts, which shared edges hold together, of fewer faces than that.
Elements of_small_parts(const Mesh& mesh, Selected, Element::Kind, ValueRange value) {
  Neighbourhood around(mesh, Neighbourhood::Reach::whole);
  const FaceComponents parts = find_face_components(around);
  std::vector<std::size_t> faces(parts.count, 0);
  for (const std::uint32_t part : parts.of_face)
    if (part != no_index) ++faces[part];
  const std::size_t largest = faces.empty() ? 0 : *std::max_element(faces.begin(), faces.end());
  const double bound = value.is_share ? value.low * static_cast<double>(largest) : value.low;
  return those<Face>(mesh, [&](Face f) { return static_cast<double>(faces[parts.of_face[f.index]]) < bound; });
}

// NaN is neither.
Elements shorter(const Mesh& mesh, Selected, Element::Kind, ValueRange value) {
  return those<Edge>(mesh, [&](Edge e) { return edge_length(mesh, e) < value.low; });
}
Elements longer(const Mesh& mesh, Selected, Element::Kind, ValueRange value) {
  return those<Edge>(mesh, [&](Edge e) { return edge_length(mesh, e) > value.low; });
}

Elements sharp(const Mesh& mesh, Selected, Element::Kind, ValueRange value) {
  const double cosine = std::cos(value.low * std::numbers::pi / 180);
  Neighbourhood around(mesh, Neighbourhood::Reach::whole);
  return those<Edge>(mesh, [&](Edge e) { return bends(around, e, cosine); });
}

Elements find_flat(const Mesh& mesh, Selected selection, Element::Kind, ValueRange value) {
  return flat_regions(mesh, selection, value.low);
}

// Those whose value of a colour map lies in a range.
Elements by_map(const Mesh& mesh, Selected, Element::Kind, ValueRange value) {
  const MapValues values(mesh, *value.map);
  Elements found;
  for (std::uint32_t i = 0; i < values.all().size(); ++i) {
    if (!value.holds(values.of(i))) continue;
    found.emplace_back().kind = value.map->sort();
    found.back().index = i;
  }
  return found;
}

template <Elements (*spread)(const Mesh&, Selected)>
Elements from_selection(const Mesh& mesh, Selected selection, Element::Kind, ValueRange) {
  return spread(mesh, selection);
}

template <Element::Kind kind>
Elements as(const Mesh& mesh, Selected selection, Element::Kind, ValueRange) {
  return converted(mesh, selection, kind);
}

constexpr Element::Kind edge_kind = Element::Kind::edge, face_kind = Element::Kind::face;

const Selector rows[] = {
    {.id = "all", .name_en = "Select everything", .name_ja = "すべてを選択", .find = find_all, .chord = "A"},
    {.id = "none", .name_en = "Select nothing", .name_ja = "選択を解除", .find = find_none, .chord = "Ctrl+Shift+A"},
    {.id = "invert",
     .name_en = "Select the others instead",
     .name_ja = "選択を反転",
     .find = find_others,
     .chord = "I"},
    {.id = "grow",
     .name_en = "Select the neighbours too",
     .name_ja = "選択を隣へ広げる",
     .find = from_selection<grown>,
     .chord = "+",
     .repeats = true,
     .needs_any = true},
    {.id = "shrink",
     .name_en = "Leave out the outermost",
     .name_ja = "選択を縁から縮める",
     .find = from_selection<shrunk>,
     .chord = "-",
     .repeats = true,
     .needs_any = true},
    {.id = "linked",
     .name_en = "Select all that is linked",
     .name_ja = "つながる全体を選択",
     .find = from_selection<linked>,
     .chord = "K",
     .needs_any = true},
    {.id = "loop",
     .name_en = "Select the loop of edges",
     .name_ja = "稜線ループを選択",
     .find = from_selection<edge_loops>,
     .chord = "L",
     .needs = edge_kind},
    {.id = "ring",
     .name_en = "Select the ring of edges",
     .name_ja = "稜線リングを選択",
     .find = from_selection<edge_rings>,
     .chord = "Shift+L",
     .needs = edge_kind},
    {.id = "as_vertices",
     .name_en = "Turn the selection into vertices",
     .name_ja = "選択を頂点に変換",
     .find = as<Element::Kind::vertex>,
     .chord = "Ctrl+1",
     .needs_any = true,
     .turns_into = Element::Kind::vertex},
    {.id = "as_edges",
     .name_en = "Turn the selection into edges",
     .name_ja = "選択を稜線に変換",
     .find = as<Element::Kind::edge>,
     .chord = "Ctrl+2",
     .needs_any = true,
     .turns_into = Element::Kind::edge},
    {.id = "as_faces",
     .name_en = "Turn the selection into faces",
     .name_ja = "選択を面に変換",
     .find = as<Element::Kind::face>,
     .chord = "Ctrl+3",
     .needs_any = true,
     .turns_into = Element::Kind::face},
    {.id = "as_halfedges",
     .name_en = "Turn the selection into halfedges",
     .name_ja = "選択を半稜線に変換",
     .find = as<Element::Kind::halfedge>,
     .chord = "Ctrl+4",
     .needs_any = true,
     .turns_into = Element::Kind::halfedge},
    {.id = "flat",
     .name_en = "Select the flat region around",
     .name_ja = "平らな領域を選択",
     .find = find_flat,
     .value = Selector::Value::size,
     .usual = "1",
     .needs = face_kind,
     .value_en = "of faces that bend by no more: degrees",
     .value_ja = "隣との曲がりの上限（度）",
     .menu_en = "Select the flat region around, within",
     .menu_ja = "平らな領域を角度を決めて選択"},
    {.id = "sharp",
     .name_en = "Select edges that bend by more than 30 degrees",
     .name_ja = "30 度より曲がる稜線を選択",
     .find = sharp,
     .value = Selector::Value::size,
     .usual = "30",
     .value_en = "that bend by more: degrees",
     .value_ja = "曲がりの下限（度）",
     .menu_en = "Select edges by how they bend",
     .menu_ja = "稜線を曲がりで選択"},
    {.id = "sides",
     .name_en = "Select faces of more than four sides",
     .name_ja = "5 角以上の面を選択",
     .find = of_sides,
     .value = Selector::Value::count,
     .usual = "5..",
     .value_en = "how many: 3, 5.. or 3..4",
     .value_ja = "角の数：3、5..、3..4 など",
     .menu_en = "Select faces by the number of sides",
     .menu_ja = "面を角の数で選択"},
    {.id = "valence",
     .name_en = "Select vertices of more than six edges",
     .name_ja = "稜線が 7 本以上の頂点を選択",
     .find = of_valence,
     .value = Selector::Value::count,
     .usual = "7..",
     .value_en = "how many: 3, 7.. or 3..5",
     .value_ja = "稜線の数：3、7..、3..5 など",
     .menu_en = "Select vertices by the number of edges",
     .menu_ja = "頂点を稜線の数で選択"},
    {.id = "shorter",
     .name_en = "Select edges shorter than",
     .name_ja = "指定より短い稜線を選択",
     .find = shorter,
     .value = Selector::Value::size,
     .value_en = "a length",
     .value_ja = "長さ"},
    {.id = "longer",
     .name_en = "Select edges longer than",
     .name_ja = "指定より長い稜線を選択",
     .find = longer,
     .value = Selector::Value::size,
     .value_en = "a length",
     .value_ja = "長さ"},
    {.id = "parts",
     .name_en = "Select small parts",
     .name_ja = "小さな部分を選択",
     .find = of_small_parts,
     .value = Selector::Value::part_size,
     .usual = "1%",
     .value_en = "of fewer faces: a number, or a share of the largest part",
     .value_ja = "この面数未満の部分（最大の部分に対する割合でも指定可）"},
    {.id = "by",
     .name_en = "Select by a colour map",
     .name_ja = "色分けの値で選択",
     .find = by_map,
     .value = Selector::Value::map_range},
};

}  // namespace

std::span<const Selector> selectors() { return rows; }

const Selector* find_selector(std::string_view id) { return find_row(rows, id); }

std::string syntax_of(const Selector& row) {
  const std::string id(row.id);
  if (row.value == Selector::Value::none) return id;
  if (row.value == Selector::Value::map_range) return id + " MAP LOW HIGH";
  const std::string value = row.value == Selector::Value::count       ? "N..M"
                            : row.value == Selector::Value::part_size ? "N|N%"
                                                                      : "X";
  return id + (row.usual.empty() ? " " + value : " [" + value + "]");
}

std::optional<ValueRange> parse_value(const Selector& row, std::string_view text) {
  const auto number = [](std::string_view t) {
    const auto n = parse_double(t);
    return n && *n >= 0 ? n : std::nullopt;
  };
  if (row.value == Selector::Value::none || row.value == Selector::Value::map_range) return std::nullopt;
  if (row.value == Selector::Value::part_size && text.ends_with('%')) {
    const auto percent = number(text.substr(0, text.size() - 1));
    return percent && *percent <= 100 ? std::optional(ValueRange{.low = *percent / 100, .is_share = true})
                                      : std::nullopt;
  }
  const std::size_t dots = row.value == Selector::Value::count ? text.find("..") : std::string_view::npos;
  if (dots == std::string_view::npos) {
    const auto n = number(text);
    return n ? std::optional(ValueRange{*n, *n}) : std::nullopt;
  }
  const std::string_view before = text.substr(0, dots), behind = text.substr(dots + 2);
  const auto low = before.empty() ? std::optional(0.0) : number(before);
  const auto high = behind.empty() ? std::optional(std::numeric_limits<double>::infinity()) : number(behind);
  if (!low || !high || *low > *high || (before.empty() && behind.empty())) return std::nullopt;
  return ValueRange{*low, *high};
}

std::optional<ValueRange> parse_values(const Selector& row, std::span<const std::string_view> words) {
  if (row.value == Selector::Value::none) return words.empty() ? std::optional(ValueRange()) : std::nullopt;
  if (row.value == Selector::Value::map_range) {
    const ColourMap* const map = words.size() == 3 ? find_colour_map(words[0]) : nullptr;
    const auto low = map ? parse_double(words[1]) : std::nullopt, high = map ? parse_double(words[2]) : std::nullopt;
    return low && high && *low <= *high ? std::optional(ValueRange{*low, *high, map}) : std::nullopt;
  }
  if (words.size() > 1 || (words.empty() && row.usual.empty())) return std::nullopt;
  return parse_value(row, words.empty() ? row.usual : words[0]);
}

Text missing_for(const Selector& row, const ValueRange& values, const Mesh& mesh, std::span<const Element> selection) {
  return values.map && !has_numbers(mesh, *values.map) ? no_numbers(*values.map) : missing_for(row, selection);
}

Text missing_for(const Selector& row, std::span<const Element> selection) {
  if (row.needs_any && selection.empty())
    return {"select something first; it goes on from there", "先に何か選択してください。そこから広げます"};
  if (!row.needs) return {};
  const bool wants_edge = *row.needs == Element::Kind::edge;
  for (const Element& e : selection)
    if (e.kind == *row.needs || (wants_edge && e.kind == Element::Kind::halfedge)) return {};
  return wants_edge
             ? Text{"select an edge first; it goes on from there", "先に稜線を選択してください。そこから広げます"}
             : Text{"select a face first; it goes on from there", "先に面を選択してください。そこから広げます"};
}

}  // namespace ryosen
