// Reads, prints and matches the line of an operator by its parameters.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ryosen/base/element.h"
#include "ryosen/base/number_text.h"
#include "ryosen/mesh/names.h"
#include "ryosen/ops/parameters/op_parameter.h"

namespace ryosen {

// The error for an argument that cannot be parsed; `expected` in Japanese includes its particle.
Text not_understood(std::string_view argument, const Text& expected);
// The error for an argument that does not match the operator's syntax (empty if it takes none).
Text not_of_syntax(std::string_view argument, std::string_view syntax);
Text argument_missing(std::string_view syntax);

// Sequential reader of the arguments of an operator's script line; remembers the first error. After it every further
// read returns none, so that all arguments can be read before failed() is asked.
class ArgumentReader {
 public:
  ArgumentReader(const Mesh& mesh, std::span<const std::string_view> arguments, const OpLine& line)
      : mesh_(mesh), arguments_(arguments), line_(line) {}

  bool at_end() const { return next_ >= arguments_.size(); }
  bool failed() const { return error_ != NameError::none; }
  std::size_t left() const { return arguments_.size() - next_; }
  // The next argument as written, or empty; does not consume it.
  std::string_view peek() const { return at_end() ? std::string_view() : arguments_[next_]; }

  // The element that a function finds by its name.
  template <class Handle>
  Handle read(Named<Handle> (*find)(const Mesh&, std::string_view)) {
    if (failed()) return Handle();
    if (at_end()) return fail_missing(), Handle();
    Named<Handle> named = find(mesh_, take());
    if (!named.ok()) fail(named.error, std::move(named.sentence));
    return named.ok() ? named.element : Handle();
  }
  Vertex vertex() { return read(find_vertex); }
  Vertex copy();  // if the point has several: ambiguous unless the argument names one
  Face face() { return read(find_face); }
  Halfedge halfedge() { return read(find_edge); }
  double number();
  glm::dvec3 place();                    // X,Y,Z, finite
  bool word(std::string_view expected);  // consumes it if it is next
  void skip() { ++next_; }               // not at the end
  // The last argument that was read; empty before the first.
  std::string_view last() const { return next_ == 0 ? std::string_view() : arguments_[next_ - 1]; }

  // The halfedge that ends at v in the intended corner: the one named by the next argument (P-V), if any, else the only
  // one of `corners`. Several without an argument are ambiguous; none gives none.
  Halfedge corner(Vertex v, std::span<const Halfedge> corners);

  void fail(NameError error, Text sentence);
  void fail_at(std::string_view argument);  // the argument does not fit the syntax
  void fail_missing();

  NameError error() const { return error_; }
  const Text& sentence() const { return sentence_; }

 private:
  std::string_view take();

  const Mesh& mesh_;
  std::span<const std::string_view> arguments_;
  const OpLine& line_;
  std::size_t next_ = 0;
  NameError error_ = NameError::none;
  Text sentence_;
};

// "A-B [start|end|mid|X,Y,Z]": blanks between places, [ ] around optional ones, `|` between the values of a place and
// ` | ` between whole lists; `...` repeats.
std::string syntax_of(const OpLine& line);

// "start|end|mid|X,Y,Z": what may be in a place.
std::string syntax_of(const OpParameter& parameter);

// Reads the arguments into the operator. The first error stays in the reader.
void read_line(const OpLine& line, const Mesh& mesh, ArgumentReader& in, void* op);
// Prints the arguments, each behind a blank. Inverse of read_line() on the mesh where it was printed.
std::string print_line(const OpLine& line, const Mesh& mesh, const void* op);
// The halfedge of an operator on one edge; none of others.
Halfedge halfedge_of(const OpLine& line, const void* op);

// The place of a line whose position is dragged by hand; null where there is none.
const OpParameter* dragged_place(const OpLine& line);
// Puts a position into that place, which must be there, and takes other values out of it.
void set_dragged(const OpLine& line, void* op, const glm::dvec3& position);

// An argument of a line whose elements need not exist: a word, or any element of a kind.
struct OpWord {
  std::string_view text;
  std::optional<Element::Kind> kind = {};

  OpWord(std::string_view word) : text(word) {}
  OpWord(Element::Kind any) : kind(any) {}
};
// Words, and a kind of elements before them.
std::vector<OpWord> op_words(std::span<const std::string_view> words);
std::vector<OpWord> op_words(Element::Kind kind, std::size_t count, std::span<const std::string_view> words);

// The index of the first word that fits none of the lists: words.size() if one is missing, none if all fit. Cost: the
// words times the parameters.
std::optional<std::size_t> first_misfit(const OpLine& line, std::span<const OpWord> words);
// The kind of element that may come next: a vertex before an edge before a face; none where none may.
std::optional<Element::Kind> next_element(const OpLine& line, std::span<const OpWord> words);
// Whether a list takes any number of elements.
bool takes_any_number(const OpLine& line);

}  // namespace ryosen
