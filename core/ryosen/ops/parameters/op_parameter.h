// The parameters of operators: the values that may be in each place of a line, and the members that keep them.
//
// An operator's row lists them (OpInfo::line); reading and printing its line, its syntax, and the kind of element that
// a line lacks follow from that list (op_line.h). member_values.h makes the values from members.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "ryosen/base/handle.h"
#include "ryosen/base/message.h"

namespace ryosen {

class ArgumentReader;
class Mesh;

enum class OpValueKind { vertex, edge, face, number, position, word };

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
  Halfedge (*halfedge)(const void* op) = nullptr;  // of an edge; of a list with one
};

// A place of a line: one of up to four values.
struct OpParameter {
  enum class Need { required, optional, list };  // a list takes one value or more
  Need need = Need::required;
  std::array<OpValue, 4> values = {};
  std::string_view more = "";  // how the syntax calls further values of a list; empty where `...` does
  // Words that replace the syntax where a word is not understood, or missing.
  std::string_view expected_en = "", expected_ja = "", missing_en = "", missing_ja = "";

  constexpr std::size_t count() const {
    std::size_t n = 0;
    while (n < values.size() && !values[n].called.empty()) ++n;
    return n;
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
