// What an algorithm can be told: a row per parameter, and the values that were given. Whoever asks for values (flags of
// the command line, words of a script, fields of the window) reads the rows and gives texts; what is wrong with a text
// is said here, in the same words for all.
//
// A length is in units of the mesh, or with `%` in hundredths of the diagonal of the mesh's bounding box: `0.5`,
// `0.1%`. It is turned into units of the mesh when the algorithm begins, so a script does the same to the same mesh. An
// angle is in degrees; a place is X,Y,Z; elements are names separated by commas; a flag is `on` or `off`, and on the
// command line its name alone means on.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ryosen/base/element.h"
#include "ryosen/base/message.h"
#include "ryosen/base/row_words.h"
#include "ryosen/mesh/names.h"

namespace ryosen {

enum class ParameterKind { number, count, length, ratio, angle, place, choice, flag, elements };

struct Choice {
  std::string_view id, en, ja;
};

// The rows of a table as choices.
template <class Rows>
std::vector<Choice> choices_of(const Rows& rows) {
  std::vector<Choice> choices;
  for (const auto& row : rows) choices.push_back({row.id, row.en, row.ja});
  return choices;
}

struct ParameterRow {
  std::string_view id = "";  // these five as in RowWords
  ParameterKind kind;
  std::string_view name_en = "", name_ja = "";
  std::string_view help_en = "", help_ja = "";
  bool is_required = false;
  std::string_view initial = "";  // the value unless one is given, as a text; empty: it may be left out
  // Of numbers; unless they are given, those of the kind.
  std::optional<double> smallest = {}, largest = {};
  bool excludes_smallest = false, excludes_largest = false;
  std::string_view unit_en = "", unit_ja = "";  // of a number or a count
  std::vector<Choice> choices = {};
  // Ids separated by ", ", the same for all of them and this one's among them: at least one of these must be given.
  std::string_view one_of = "";
  bool is_worked_on = false;  // elements that it is done to, in place of all: in the window first what is selected
  std::string (*proposed)(const Mesh& mesh) = nullptr;  // what its field begins with, as this mesh has it
};

inline ParameterRow parameter_row(const RowWords& words, ParameterRow row) { return with_words(words, std::move(row)); }

// What its field begins with: what is proposed for the mesh, else its initial value.
std::string first_text(const ParameterRow& row, const Mesh& mesh);

// LENGTH, COUNT, on|off, the ids of a choice: what stands in the place of a value in a syntax.
std::string placeholder(const ParameterRow& row);
// "a length from 0 up, in units of the mesh or with % of its diagonal"
Text expected_value(const ParameterRow& row);
// What is expected, and whether it must be given or what it is else.
Text described(const ParameterRow& row);
// Whether it is among the fewest that must be given: it is required, or the first of those of which one is.
bool must_be_given(std::span<const ParameterRow> rows, const ParameterRow& row);

// A value of its row's kind.
struct ParameterValue {
  double number = 0;               // for a choice its place in the list, for a flag 1 where it is on
  bool is_percent = false;         // of a length
  bool was_percent = false;        // the same once it is in units of the mesh
  glm::dvec3 place{0.0};           // of a place
  std::vector<std::string> names;  // of elements
  std::vector<Element> elements;   // once they are looked up, or where they were set themselves
};

struct ReadValues;

// The word for the selection as the value of elements.
constexpr std::string_view selection_word = "selected";
bool means_selection(const ParameterRow& row, std::string_view text);

class ParameterValues {
 public:
  // With the initial values.
  explicit ParameterValues(std::span<const ParameterRow> rows = {});

  // Takes a value as it is written. A sentence where it is none of this parameter; `called` is what the sentence calls
  // it.
  std::optional<Text> set(std::string_view id, std::string_view text, std::string_view called);
  // Values of a parameter of that kind, which on() checks; a length in units of the mesh.
  void set_number(std::string_view id, double number) { value_to_set(id, ParameterKind::number).number = number; }
  void set_length(std::string_view id, double length) { value_to_set(id, ParameterKind::length).number = length; }
  void set_place(std::string_view id, const glm::dvec3& place) { value_to_set(id, ParameterKind::place).place = place; }
  void set_names(std::string_view id, std::vector<std::string> names) {
    value_to_set(id, ParameterKind::elements).names = std::move(names);
  }
  // Elements that on() need not look up as long as they are alive, and their names for the line; a halfedge is its
  // edge.
  void set_elements(std::string_view id, std::vector<Element> elements, std::vector<std::string> names) {
    for (Element& e : elements)
      if (e.kind == Element::Kind::halfedge) e = edge(e.halfedge());
    set_names(id, std::move(names));
    values_[index_of(id)]->elements = std::move(elements);
  }
  // The sentence about what must be given and was not, which calls the parameters so; none where nothing is missing.
  std::optional<Text> fault_of_missing(const std::function<std::string(const ParameterRow&)>& called) const;
  // Lengths in units of the mesh and elements looked up: what an algorithm gets. Fails where a number is not finite.
  ReadValues on(const Mesh& mesh) const;

  // Of the parameter with this id and of that kind. Only has() may be asked where it may be left out and was.
  bool has(std::string_view id) const;
  double number(std::string_view id) const { return value(id, ParameterKind::number).number; }
  std::size_t count(std::string_view id) const;
  double length(std::string_view id) const { return value(id, ParameterKind::length).number; }
  // Whether a length was written with %: as a share of the diagonal.
  bool was_share(std::string_view id) const { return value(id, ParameterKind::length).was_percent; }
  double ratio(std::string_view id) const { return value(id, ParameterKind::ratio).number; }
  double angle_rad(std::string_view id) const;
  const glm::dvec3& place(std::string_view id) const { return value(id, ParameterKind::place).place; }
  std::string_view choice(std::string_view id) const;  // its id
  bool flag(std::string_view id) const { return value(id, ParameterKind::flag).number != 0; }
  const std::vector<Element>& elements(std::string_view id) const;

  std::span<const ParameterRow> rows() const { return rows_; }
  // As it is written; empty where there is none.
  std::string text(std::string_view id) const;
  // "distance=0.01 steps=3", all that are there; the first without its name where that is wanted.
  std::string line(bool without_first_name = false) const;
  // By place in rows(); null where there is none.
  const ParameterValue* at(std::size_t i) const { return values_[i] ? &*values_[i] : nullptr; }

 private:
  // By place in rows(); behind them where there is none.
  std::size_t index_of(std::string_view id) const;
  const ParameterValue& value(std::string_view id, ParameterKind kind) const;
  ParameterValue& value_to_set(std::string_view id, ParameterKind kind);
  std::string text_at(std::size_t i) const;

  std::span<const ParameterRow> rows_;  // of an algorithm, which outlives its values
  std::vector<std::optional<ParameterValue>> values_;
};

// Values, or why there are none.
struct ReadValues {
  std::optional<ParameterValues> values;
  NameError error = NameError::none;
  std::string name = {};  // of the element that is not there
  Text sentence = {};
  bool lacks_extent = false;  // a length is a share of the diagonal, and that of this mesh is 0
};

// `name=value` words in any order; a first word without `=` is the value of the first parameter. Where `selected` is
// given, that word as the value of elements means these names.
ReadValues read_values(std::span<const ParameterRow> rows, std::span<const std::string_view> words,
                       const std::vector<std::string>* selected = nullptr);
// The texts of fields, one for each row; an empty one gives no value, and `selected` is as above. Sentences call the
// rows by their names.
ReadValues read_fields(std::span<const ParameterRow> rows, std::span<const std::string> texts,
                       const std::vector<std::string>* selected = nullptr);
// "distance=LENGTH [steps=COUNT]": the syntax of such words.
std::string syntax_of(std::span<const ParameterRow> rows);

}  // namespace ryosen
