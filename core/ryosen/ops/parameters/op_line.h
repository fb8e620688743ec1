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
#include "ryosen/ops/parameters/op_argument.h"
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
  ArgumentReader(const Mesh& mesh, std::span<const OpArgument> arguments, const OpLine& line)
      : mesh_(mesh), arguments_(arguments), line_(line) {}

  bool at_end() const { return next_ >= arguments_.size(); }
  bool failed() const { return error_ != NameError::none; }
  std::size_t left() const { return arguments_.size() - next_; }
  // The next argument, or an empty word; does not consume it.
  OpArgument peek() const { return at_end() ? OpArgument(std::string_view()) : arguments_[next_]; }
  // The next argument as it is printed.
  std::string peek_text() const { return print_argument(mesh_, peek()); }
  // The halfedge that halfedge() would read, or why none; does not consume it.
  Named<Halfedge> peek_halfedge() const { return named(peek(), find_edge); }
  bool is_face_next() const;

  // The element of the next argument, or the one that a function finds by the word. An edge is the halfedge that its
  // name means, from the lower point to the higher one.
  template <class Handle>
  Handle read(Named<Handle> (*find)(const Mesh&, std::string_view)) {
    if (failed()) return Handle();
    if (at_end()) return fail_missing(), Handle();
    Named<Handle> named = this->named(take(), find);
    if (!named.ok()) fail(named.error, std::move(named.sentence));
    return named.ok() ? named.element : Handle();
  }
  Vertex vertex() { return read(find_vertex); }
  Vertex copy();  // if the point has several: ambiguous unless the argument is one or names one
  Face face() { return read(find_face); }
  Halfedge halfedge() { return read(find_edge); }
  double number();
  glm::dvec3 place();                    // X,Y,Z, finite
  bool word(std::string_view expected);  // consumes it if it is next
  void skip() { ++next_; }               // not at the end
  // The last argument that was read, as it is printed; empty before the first.
  std::string last_text() const { return next_ == 0 ? std::string() : print_argument(mesh_, arguments_[next_ - 1]); }

  // The halfedge that ends at v in the intended corner: the one that the next argument is (P-V), if any, else the only
  // one of `corners`. Several without an argument are ambiguous; none gives none.
  Halfedge corner(Vertex v, std::span<const Halfedge> corners);

  void fail(NameError error, Text sentence);
  void fail_at(const OpArgument& argument);  // it does not fit the syntax
  void fail_missing();

  NameError error() const { return error_; }
  const Text& sentence() const { return sentence_; }

 private:
  const OpArgument& take() { return arguments_[next_++]; }
  // The element of an argument as handles of this kind have it; none where it is of another kind or not alive.
  std::optional<Element> element_as(Element::Kind kind, const OpArgument& argument) const;
  // The word that find() is asked for in place of an argument that is not such an element, for it to tell why.
  std::string word_to_find(const OpArgument& argument) const;
  template <class Handle>
  Named<Handle> named(const OpArgument& argument, Named<Handle> (*find)(const Mesh&, std::string_view)) const {
    if (argument.is_word()) return find(mesh_, argument.word());
    if (const auto element = element_as(Element(Handle()).kind, argument))
      return {Handle(element->index), NameError::none, {}};
    return find(mesh_, word_to_find(argument));
  }

  const Mesh& mesh_;
  std::span<const OpArgument> arguments_;
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

// The list that a line with this first argument is of; the first one where it fits none.
OpParameters list_meant(const OpLine& line, const OpArgument& first);

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

// The index of the first argument that fits none of the lists, whether or not its element exists: arguments.size() if
// one is missing, none if all fit. Cost: the arguments times the parameters.
std::optional<std::size_t> first_misfit(const OpLine& line, std::span<const OpArgument> arguments);
// The kind of element that may come next: a vertex before an edge before a face; none where none may.
std::optional<Element::Kind> next_element(const OpLine& line, std::span<const OpArgument> arguments);
// Whether a list takes any number of elements.
bool takes_any_number(const OpLine& line);

}  // namespace ryosen
