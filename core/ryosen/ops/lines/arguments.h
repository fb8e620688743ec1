// Sequential reader of the arguments of an operator's script line; remembers the first error.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "ryosen/mesh/names.h"
#include "ryosen/ops/op.h"

namespace ryosen {

// After an error every further read returns none, so an operator can read all its arguments and check once, through
// result().
class ArgumentReader {
 public:
  ArgumentReader(const Mesh& mesh, std::span<const std::string_view> arguments, std::string_view syntax)
      : mesh_(mesh), arguments_(arguments), syntax_(syntax) {}

  bool at_end() const { return next_ >= arguments_.size(); }
  bool failed() const { return error_ != NameError::none; }
  std::size_t left() const { return arguments_.size() - next_; }
  // The next argument as written, or empty; does not consume it.
  std::string_view peek() const { return at_end() ? std::string_view() : arguments_[next_]; }

  Vertex vertex() { return read(find_vertex); }
  Vertex copy();  // if the point has several: ambiguous unless the argument names one
  Face face() { return read(find_face); }
  Halfedge halfedge() { return read(find_edge); }
  double number();
  glm::dvec3 place();                    // X,Y,Z, finite
  bool word(std::string_view expected);  // consumes it if it is next

  // The halfedge that ends at v in the intended corner: the one named by the next argument (P-V), if any, else the only
  // one of `corners`. Several without an argument are ambiguous; none gives none.
  Halfedge corner(Vertex v, std::span<const Halfedge> corners);

  void fail(NameError error, Text sentence);

  // The operator, if there was no error and no argument is left over.
  template <class Op>
  Parsed<Op> result(const Op& op) {
    if (!failed() && !at_end()) fail_at(arguments_[next_]);
    if (failed()) return {std::nullopt, error_, sentence_};
    return {op, NameError::none, {}};
  }

 private:
  void fail_at(std::string_view argument);
  void fail_missing();
  std::string_view take();

  template <class Handle>
  Handle read(Named<Handle> (*find)(const Mesh&, std::string_view)) {
    if (failed()) return Handle();
    if (at_end()) return fail_missing(), Handle();
    Named<Handle> named = find(mesh_, take());
    if (!named.ok()) fail(named.error, std::move(named.sentence));
    return named.ok() ? named.element : Handle();
  }

  const Mesh& mesh_;
  std::span<const std::string_view> arguments_;
  std::string_view syntax_;
  std::size_t next_ = 0;
  NameError error_ = NameError::none;
  Text sentence_;
};

// Parses X,Y,Z; none if it is not three finite numbers.
std::optional<glm::dvec3> parse_place(std::string_view text);
std::string format_place(const glm::dvec3& place);

}  // namespace ryosen
