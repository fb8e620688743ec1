// The parameters of operators: the values that may be in each place of a line, and the members that keep them.
//
// An operator's row lists them (OpInfo::line); reading and printing its line, its syntax, its fields in the window, its
// part of `help json`, what a hand drags, and the kind of element that a line lacks follow from that list (op_line.h).
// member_values.h makes the values from members.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ryosen/base/element.h"
#include "ryosen/base/message.h"
#include "ryosen/base/row_words.h"

namespace ryosen {

class ArgumentReader;
class Mesh;
struct ColumnLengths;

enum class OpValueKind { vertex, edge, face, number, position, word };

constexpr bool is_element(OpValueKind kind) {
  return kind == OpValueKind::vertex || kind == OpValueKind::edge || kind == OpValueKind::face;
}

// A kind of value, or a word, in a place of a line. The functions get the operator; a value without them is read and
// printed by the operator itself (OpLine).
struct OpValue {
  OpValueKind kind = OpValueKind::word;
  std::string_view called = "";  // in the syntax: A-B, fN, X,Y,Z; of a word itself
  void (*read)(ArgumentReader& in, void* op) = nullptr;
  // Whether the operator keeps a value of this kind here.
  bool (*is_held)(const void* op) = nullptr;
  // Appends a blank and the value; a list all its values, each behind a blank. A word has none, since it is printed as
  // it is called; neither has a value that another one of the same list prints.
  void (*print)(const Mesh& mesh, const void* op, std::string& line) = nullptr;
  Halfedge (*halfedge)(const void* op) = nullptr;               // of an edge; of a list with one
  void (*clear)(void* op) = nullptr;                            // takes it out, where its place may be empty
  void (*set)(void* op, const glm::dvec3& position) = nullptr;  // of a position
  std::string_view name_en = "", name_ja = "";                  // where one of several values is chosen
};

// How the position in a place of a line is dragged by hand: a gesture (Gesturing::begin) does the operator on trial and
// moves what it made, all of it the same way; its end gives the operator the position.
struct OpDrag {
  // The elements that move, on a mesh that had so many elements before the operator was applied.
  std::vector<Element> (*moved)(const Mesh& mesh, const void* op, const ColumnLengths& before);
  // The place at which it begins, on the mesh before; the position is then that at which it ends. Without it the
  // position is how far it has moved.
  glm::dvec3 (*from)(const Mesh& mesh, const void* op) = nullptr;
  bool begins_flat = false;                           // what is new has no extent until it has moved
  bool along_normal = false;                          // begins along the normal of what moves
  bool selects_moved = false;                         // selects what moves, in place of what the operator was done to
  std::string_view unmoved_en = "", unmoved_ja = "";  // said where it ends without a movement
};

// A place of a line: one of up to four values.
struct OpParameter {
  std::string_view id = "";  // these five as in RowWords; an id is unique within its list
  std::string_view name_en = "", name_ja = "";
  std::string_view help_en = "", help_ja = "";
  enum class Need { required, optional, list };  // a list takes one value or more
  Need need = Need::required;
  std::array<OpValue, 4> values = {};
  std::string_view more = "";  // how the syntax calls further values of a list; empty where `...` does
  const OpDrag* drag = nullptr;
  // Words that replace the syntax where a word is not understood, or missing.
  std::string_view expected_en = "", expected_ja = "", missing_en = "", missing_ja = "";

  constexpr std::size_t count() const {
    std::size_t n = 0;
    while (n < values.size() && !values[n].called.empty()) ++n;
    return n;
  }
  // Whether it takes no element: a number, a position or a word.
  constexpr bool is_told() const {
    for (std::size_t i = 0; i < count(); ++i)
      if (is_element(values[i].kind)) return false;
    return true;
  }
  constexpr bool is_optional() const { return need == Need::optional; }
  constexpr bool is_list() const { return need == Need::list; }
};
using OpParameters = std::span<const OpParameter>;

// The line of an operator: one of several lists of parameters.
struct OpLine {
  std::array<OpParameters, 3> lists = {};  // the first empty one ends them
  // Reads and prints the places from the first value without functions on.
  void (*read_rest)(const Mesh& mesh, ArgumentReader& in, void* op) = nullptr;
  void (*print_rest)(const Mesh& mesh, const void* op, std::string& line) = nullptr;
  // The text expected in place of the last word, if the values do not go together.
  std::optional<Text> (*fault)(const Mesh& mesh, const void* op) = nullptr;
  // Changes what was read to what is meant.
  void (*normalise)(const Mesh& mesh, void* op) = nullptr;

  constexpr std::span<const OpParameters> all_lists() const {
    std::size_t n = 0;
    while (n < lists.size() && !lists[n].empty()) ++n;
    return std::span(lists).first(n);
  }
};

}  // namespace ryosen
