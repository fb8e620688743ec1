// Sequential reader of the arguments of an operator's script line; remembers the first error.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "ryosen/base/number_text.h"
#include "ryosen/mesh/names.h"
#include "ryosen/ops/parameters/op_parameter.h"

namespace ryosen {

// The error for an argument that cannot be parsed; `expected` in Japanese includes its particle.
Text not_understood(std::string_view argument, const Text& expected);
// The error for an argument that does not match the operator's syntax (empty if it takes none).
Text not_of_syntax(std::string_view argument, std::string_view syntax);
Text argument_missing(std::string_view syntax);

// After an error every further read returns none, so that all arguments can be read before failed() is asked.
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

}  // namespace ryosen
