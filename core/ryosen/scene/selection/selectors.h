// The table of what can be selected at once: all, what grows from the selection, and what has a trait.
//
// To add one, write its function and its row. The command `select`, its help, the menu, keys and the tests read the
// table.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "ryosen/base/element.h"
#include "ryosen/base/message.h"
#include "ryosen/mesh/mesh.h"
#include "ryosen/scene/highlights/colour_maps.h"

namespace ryosen {

// From `low` to `high`, both included.
struct ValueRange {
  double low = 0, high = 0;
  const ColourMap* map = nullptr;  // of which these are values
  bool is_share = false;           // of the largest part

  bool holds(double value) const { return low <= value && value <= high; }
};

struct Selector {
  // What it takes behind its id: nothing, a number of things (N, N..M, N.., ..N), a length or angle of 0 and more, the
  // id of a colour map and a range of its values, or a number of faces or a share (N%) of those of the largest part.
  enum class Value { none, count, size, map_range, part_size };

  std::string_view id;
  std::string_view name_en, name_ja;  // in the menu, where it has the value `usual`
  Elements (*find)(const Mesh& mesh, std::span<const Element> selection, Element::Kind sort, ValueRange value);
  Value value = Value::none;
  std::string_view usual = "";  // the value where none is said; empty where one must be
  std::string_view chord = "";
  bool repeats = false;  // while its key is held
  // What must be selected for it; none where it does not look at the selection.
  std::optional<Element::Kind> needs = std::nullopt;
  bool needs_any = false;  // of any kind
  // What is found is of this kind, which the pointer picks from then on.
  std::optional<Element::Kind> turns_into = std::nullopt;
  // What its value is, where the menu has a field for it, in which `usual` stands at first; and the entry of the menu
  // that has this field, where the name already says the usual value.
  std::string_view value_en = "", value_ja = "";
  std::string_view menu_en = "", menu_ja = "";
};

// `sort` is what elements `all` is about, and `invert` where nothing is selected, and no other row.
std::span<const Selector> selectors();
const Selector* find_selector(std::string_view id);
// "sides N|N..M|N..|..M"
std::string syntax_of(const Selector& row);
// Whether the menu can offer it: with its usual value, or with a field.
inline bool is_in_menu(const Selector& row) {
  return row.value == Selector::Value::none || !row.usual.empty() || !row.value_en.empty();
}
// A value as the row takes it.
std::optional<ValueRange> parse_value(const Selector& row, std::string_view text);
// The same from the words behind the id, where it may say none.
std::optional<ValueRange> parse_values(const Selector& row, std::span<const std::string_view> words);
// What has to be selected before it can do anything; empty where that is so.
Text missing_for(const Selector& row, std::span<const Element> selection);
// The same, and what the mesh lacks for these values.
Text missing_for(const Selector& row, const ValueRange& values, const Mesh& mesh, std::span<const Element> selection);

}  // namespace ryosen
