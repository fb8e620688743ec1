#include "ryosen/algo/parameters.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>

#include "ryosen/base/enum_table.h"
#include "ryosen/base/number_text.h"
#include "ryosen/base/rows.h"
#include "ryosen/base/split_list.h"
#include "ryosen/geometry/box.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/mesh/find_element.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/mesh/names.h"

namespace ryosen {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest_count = 1e15;  // whole in a double

struct KindRow {
  ParameterKind kind;
  std::string_view placeholder;
  std::string_view en, ja;
  std::string_view unit_en, unit_ja;
  double smallest, largest;
};

constexpr std::array kinds{
    KindRow{ParameterKind::number, "NUMBER", "a number", "数", "", "", -infinity, infinity},
    KindRow{ParameterKind::count, "COUNT", "a whole number", "整数", "", "", 0, largest_count},
    KindRow{ParameterKind::length, "LENGTH", "a length", "長さ", "in units of the mesh or with % of its diagonal",
            "メッシュの単位、% を付けると対角線に対する割合", 0, infinity},
    KindRow{ParameterKind::ratio, "RATIO", "a ratio", "比率", "", "", 0, 1},
    KindRow{ParameterKind::angle, "ANGLE", "an angle", "角度", "in degrees", "度", 0, 180},
    KindRow{ParameterKind::place, "X,Y,Z", "a place X,Y,Z", "座標 X,Y,Z", "in units of the mesh", "メッシュの単位",
            -infinity, infinity},
    KindRow{ParameterKind::choice, "", "one of ", "", "", "", -infinity, infinity},
    KindRow{ParameterKind::flag, "on|off", "on or off", "on か off", "", "", -infinity, infinity},
    KindRow{ParameterKind::elements, "NAME,...", "names of elements, separated by commas", "要素の名前（コンマ区切り）",
            "", "", -infinity, infinity},
};

static_assert(rows_are_in_order(kinds, &KindRow::kind));

const KindRow& kind_of(const ParameterRow& row) { return kinds[static_cast<std::size_t>(row.kind)]; }
double smallest_of(const ParameterRow& row) { return row.smallest.value_or(kind_of(row).smallest); }
double largest_of(const ParameterRow& row) { return row.largest.value_or(kind_of(row).largest); }

bool is_in_range(const ParameterRow& row, double number) {
  const double least = smallest_of(row), most = largest_of(row);
  return (row.excludes_smallest ? number > least : number >= least) &&
         (row.excludes_largest ? number < most : number <= most);
}

// A whole number without an exponent, as one writes it.
std::string bound_text(double bound) {
  const bool is_whole = std::abs(bound) < largest_count && bound == std::floor(bound);
  return is_whole ? std::to_string(static_cast<std::int64_t>(bound)) : format_double(bound);
}

Text range_text(const ParameterRow& row) {
  const double least = smallest_of(row), most = largest_of(row);
  const bool has_least = std::isfinite(least), has_most = std::isfinite(most) && most < largest_count;
  const std::string a = bound_text(least), b = bound_text(most);
  Text text;
  if (has_least) text.en += (row.excludes_smallest ? " above " : " from ") + a;
  if (has_least) text.ja += a + (row.excludes_smallest ? " より大きく" : " 以上");
  if (has_most) text.en += (row.excludes_largest ? " below " : " to ") + b;
  if (has_most) text.ja += (has_least ? " " : "") + b + (row.excludes_largest ? " 未満" : " 以下");
  if (has_least && !has_most && !row.excludes_smallest) text.en += " up";
  return text;
}

std::optional<ParameterValue> read_value(const ParameterRow& row, std::string_view text) {
  ParameterValue value;
  if (row.kind == ParameterKind::elements) {
    for (std::string_view name : split_list(text)) {
      if (!is_element_name(name) && !parse_slot_range(name)) return std::nullopt;
      value.names.emplace_back(name);
    }
    return value;
  }
  if (row.kind == ParameterKind::place) {
    const auto place = parse_place(text);
    if (!place) return std::nullopt;
    value.place = *place;
    return value;
  }
  if (row.kind == ParameterKind::flag || row.kind == ParameterKind::choice) {
    std::vector<std::string_view> words{"off", "on"};
    if (row.kind == ParameterKind::choice) words.clear();
    for (const Choice& choice : row.choices) words.push_back(choice.id);
    const auto found = std::find(words.begin(), words.end(), text);
    if (found == words.end()) return std::nullopt;
    value.number = static_cast<double>(found - words.begin());
    return value;
  }
  value.is_percent = row.kind == ParameterKind::length && text.ends_with('%');
  const auto number = parse_double(value.is_percent ? text.substr(0, text.size() - 1) : text);
  if (!number || (row.kind == ParameterKind::count && *number != std::floor(*number))) return std::nullopt;
  // How long a share is says the mesh; only its sign is known before.
  if (value.is_percent ? *number < 0 : !is_in_range(row, *number)) return std::nullopt;
  value.number = *number;
  return value;
}

// That share of the diagonal of the bounding box; on the way nothing is larger than the result or the box.
double share_of_diagonal(const Mesh& mesh, double share) {
  Box box;
  for (const Vertex v : live_vertices(mesh))
    if (is_finite(mesh.position(v))) box.add(mesh.position(v));
  if (box.is_empty()) return 0;
  const glm::dvec3 half = 0.5 * box.highest - 0.5 * box.lowest;
  const double largest = std::max({half.x, half.y, half.z});
  return largest > 0 ? largest * (2 * share * glm::length(half / largest)) : 0;
}

Text fault_of_value(const ParameterRow& row, std::string_view text, std::string_view called) {
  const Text expected = expected_value(row);
  const std::string name(called), wrong(text);
  return {name + " is " + expected.en + ", not '" + wrong + "'",
          name + " は" + expected.ja + "です（「" + wrong + "」は使えません）"};
}

ReadValues malformed(Text sentence) { return {std::nullopt, NameError::malformed, {}, std::move(sentence)}; }

ReadValues of_no_extent(const ParameterRow& row, const std::string& share) {
  const std::string id(row.id);
  return {std::nullopt,
          NameError::none,
          {},
          {"all points of the mesh are at one place or there are none, so that " + id + " " + share + " is no length",
           "メッシュの点がないか一か所にあり、対角線の長さが 0 のため、" + id + " の " + share + " は長さになりません"},
          true};
}

}  // namespace

std::string first_text(const ParameterRow& row, const Mesh& mesh) {
  const std::string proposed = row.proposed ? row.proposed(mesh) : std::string();
  return proposed.empty() ? std::string(row.initial) : proposed;
}

std::string placeholder(const ParameterRow& row) {
  std::string text(kind_of(row).placeholder);
  for (const Choice& choice : row.choices) text.append(text.empty() ? "" : "|").append(choice.id);
  return text;
}

Text expected_value(const ParameterRow& row) {
  const KindRow& kind = kind_of(row);
  Text text{std::string(kind.en), std::string(kind.ja)};
  for (const Choice& choice : row.choices) {
    const bool is_first = &choice == &row.choices.front();
    text.en.append(is_first ? "" : ", ").append(choice.id);
    text.ja.append(is_first ? " " : "、").append(choice.id);
  }
  if (!row.choices.empty()) text.ja += " のいずれか";
  const Text range = range_text(row);
  const std::string_view unit_en = row.unit_en.empty() ? kind.unit_en : row.unit_en,
                         unit_ja = row.unit_ja.empty() ? kind.unit_ja : row.unit_ja;
  text.en += range.en;
  if (!unit_en.empty()) text.en.append(", ").append(unit_en);
  if (range.ja.empty() && unit_ja.empty()) return text;
  text.ja.append("（").append(range.ja).append(range.ja.empty() || unit_ja.empty() ? "" : "、");
  text.ja.append(unit_ja).append("）");
  return text;
}

bool must_be_given(std::span<const ParameterRow> rows, const ParameterRow& row) {
  if (row.one_of.empty()) return row.is_required;
  const auto first =
      std::find_if(rows.begin(), rows.end(), [&](const ParameterRow& r) { return r.one_of == row.one_of; });
  return first->id == row.id;
}

Text described(const ParameterRow& row) {
  Text text = expected_value(row);
  if (row.is_required) return {text.en + "; must be given", text.ja + "、必須"};
  const std::string alternatives(row.one_of);
  if (!alternatives.empty())
    return {text.en + "; one of " + alternatives + " must be given",
            text.ja + "、" + alternatives + " のいずれかが必須"};
  if (row.initial.empty()) return {text.en + "; may be left out", text.ja + "、省略可"};
  const std::string initial(row.initial);
  return {text.en + "; else " + initial, text.ja + "、省くと " + initial};
}

ParameterValues::ParameterValues(std::span<const ParameterRow> rows) : rows_(rows), values_(rows.size()) {
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (!rows_[i].initial.empty()) values_[i] = read_value(rows_[i], rows_[i].initial);
}

std::optional<Text> ParameterValues::set(std::string_view id, std::string_view text, std::string_view called) {
  if (const std::size_t i = index_of(id); i < rows_.size()) {
    std::optional<ParameterValue> value = read_value(rows_[i], text);
    if (!value) return fault_of_value(rows_[i], text, called);
    values_[i] = std::move(value);
    return std::nullopt;
  }
  const std::string name(called), syntax = syntax_of(rows_);
  if (syntax.empty()) return Text{"there is nothing to tell it ('" + name + "')", "「" + name + "」は余分です"};
  return Text{"there is no parameter '" + name + "', only " + syntax,
              "「" + name + "」という指定はありません。書式：" + syntax};
}

std::optional<Text> ParameterValues::fault_of_missing(
    const std::function<std::string(const ParameterRow&)>& called) const {
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (values_[i] || !must_be_given(rows_, rows_[i])) continue;
    const Text expected = expected_value(rows_[i]);
    std::string names = called(rows_[i]);
    if (rows_[i].one_of.empty())
      return Text{names + " is missing: " + expected.en, names + " を指定してください：" + expected.ja};
    bool is_given = false;
    for (std::size_t k = i + 1; k < rows_.size(); ++k) {
      if (rows_[k].one_of != rows_[i].one_of) continue;
      is_given = is_given || values_[k];
      names += ", " + called(rows_[k]);
    }
    if (!is_given) return Text{"one of " + names + " must be given", names + " のいずれかを指定してください"};
  }
  return std::nullopt;
}

ReadValues ParameterValues::on(const Mesh& mesh) const {
  ReadValues read{*this};
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (!values_[i]) continue;
    ParameterValue& value = *read.values->values_[i];
    if (value.is_percent) {
      const bool is_none = value.number == 0;
      value.number = share_of_diagonal(mesh, value.number / 100);
      value.is_percent = false;
      value.was_percent = true;
      if (value.number == 0 && !is_none && !is_in_range(rows_[i], 0)) return of_no_extent(rows_[i], this->text_at(i));
    }
    const bool is_wrong_length = value.was_percent && !is_in_range(rows_[i], value.number);
    if (!std::isfinite(value.number) || !is_finite(value.place) || is_wrong_length)
      return malformed(fault_of_value(rows_[i], text_at(i), rows_[i].id));
    std::vector<Element>& set = value.elements;
    if (!set.empty() && std::ranges::all_of(set, [&](const Element& e) { return is_alive(mesh, e); })) continue;
    set.clear();
    for (const std::string& name : value.names) {
      if (const auto range = parse_slot_range(name)) {
        add_living(mesh, *range, set);
        continue;
      }
      NamedElement found = find_element(mesh, name);
      if (!found.element) return {std::nullopt, found.error, name, std::move(found.sentence)};
      set.push_back(*found.element);
    }
  }
  return read;
}

ParameterValue& ParameterValues::value_to_set(std::string_view id, ParameterKind kind) {
  const std::size_t i = index_of(id);
  assert(i < rows_.size() && rows_[i].kind == kind);
  static_cast<void>(kind);
  return values_[i].emplace();
}

std::size_t ParameterValues::index_of(std::string_view id) const {
  const auto row = std::find_if(rows_.begin(), rows_.end(), [&](const ParameterRow& r) { return r.id == id; });
  return static_cast<std::size_t>(row - rows_.begin());
}

bool ParameterValues::has(std::string_view id) const {
  const std::size_t i = index_of(id);
  return i < rows_.size() && values_[i];
}

const ParameterValue& ParameterValues::value(std::string_view id, ParameterKind kind) const {
  const std::size_t i = index_of(id);
  assert(i < rows_.size() && rows_[i].kind == kind && values_[i]);
  static_cast<void>(kind);
  return *values_[i];
}

std::size_t ParameterValues::count(std::string_view id) const {
  return static_cast<std::size_t>(value(id, ParameterKind::count).number);
}

double ParameterValues::angle_rad(std::string_view id) const {
  return value(id, ParameterKind::angle).number * std::numbers::pi / 180;
}

std::string_view ParameterValues::choice(std::string_view id) const {
  const auto place = static_cast<std::size_t>(value(id, ParameterKind::choice).number);
  return rows_[index_of(id)].choices[place].id;
}

const std::vector<Element>& ParameterValues::elements(std::string_view id) const {
  return value(id, ParameterKind::elements).elements;
}

std::string ParameterValues::text_at(std::size_t i) const {
  if (!values_[i]) return {};
  const ParameterValue& value = *values_[i];
  switch (rows_[i].kind) {
    case ParameterKind::choice:
      return std::string(rows_[i].choices[static_cast<std::size_t>(value.number)].id);
    case ParameterKind::flag:
      return value.number != 0 ? "on" : "off";
    case ParameterKind::place:
      return format_place(value.place);
    case ParameterKind::elements: {
      std::string list;
      for (const std::string& name : value.names) list += (list.empty() ? "" : ",") + name;
      return list;
    }
    default:
      return format_double(value.number) + (value.is_percent ? "%" : "");
  }
}

std::string ParameterValues::text(std::string_view id) const {
  const std::size_t i = index_of(id);
  return i < rows_.size() ? text_at(i) : std::string();
}

std::string ParameterValues::line(bool without_first_name) const {
  std::string text;
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (!values_[i]) continue;
    if (!text.empty()) text += ' ';
    if (i > 0 || !without_first_name) text.append(rows_[i].id).append("=");
    text += text_at(i);
  }
  return text;
}

bool means_selection(const ParameterRow& row, std::string_view text) {
  return row.kind == ParameterKind::elements && text == selection_word;
}

ReadValues read_values(std::span<const ParameterRow> rows, std::span<const std::string_view> words,
                       const std::vector<std::string>* selected) {
  ReadValues read{ParameterValues(rows)};
  std::vector<std::string_view> given;
  for (std::string_view word : words) {
    const std::size_t equals = std::min(word.find('='), word.size());
    const bool is_first = equals == word.size() && word.data() == words[0].data() && !rows.empty();
    const std::string_view id = is_first ? rows[0].id : word.substr(0, equals);
    const std::string_view text = is_first ? word : word.substr(std::min(equals + 1, word.size()));
    if (std::find(given.begin(), given.end(), id) != given.end()) {
      const std::string name(id);
      return malformed({name + " is given twice", name + " が二度指定されています"});
    }
    given.push_back(id);
    const ParameterRow* const row = find_row(rows, id);
    if (selected && row && means_selection(*row, text))
      read.values->set_names(id, *selected);
    else if (auto fault = read.values->set(id, text, id))
      return malformed(std::move(*fault));
  }
  if (auto fault = read.values->fault_of_missing([](const ParameterRow& row) { return std::string(row.id); }))
    return malformed(std::move(*fault));
  return read;
}

ReadValues read_fields(std::span<const ParameterRow> rows, std::span<const std::string> texts,
                       const std::vector<std::string>* selected) {
  assert(texts.size() == rows.size());
  ReadValues read{ParameterValues(rows)};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (texts[i].empty()) continue;
    if (selected && means_selection(rows[i], texts[i])) {
      read.values->set_names(rows[i].id, *selected);
      continue;
    }
    if (const auto fault = read.values->set(rows[i].id, texts[i], rows[i].name_en))
      return malformed({fault->en, read.values->set(rows[i].id, texts[i], rows[i].name_ja)->ja});
  }
  if (const auto fault = read.values->fault_of_missing([](const ParameterRow& r) { return std::string(r.name_en); }))
    return malformed(
        {fault->en, read.values->fault_of_missing([](const ParameterRow& r) { return std::string(r.name_ja); })->ja});
  return read;
}

std::string syntax_of(std::span<const ParameterRow> rows) {
  std::string syntax;
  for (const ParameterRow& row : rows) {
    const std::string word = std::string(row.id) + "=" + placeholder(row);
    syntax += (syntax.empty() ? "" : " ") + (row.is_required ? word : "[" + word + "]");
  }
  return syntax;
}

}  // namespace ryosen
