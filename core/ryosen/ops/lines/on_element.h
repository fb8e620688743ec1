// Bases of the operators that act on one element and are told nothing else: the element, and how a line and a click name
// it. Such an operator adds its info, check() and apply(), its warnings() if it has any, and what differs.
#pragma once

#include "ryosen/ops/lines/arguments.h"

namespace ryosen {

template <class Op, class Handle>
Parsed<Op> parse_one(const Mesh& mesh, std::span<const std::string_view> arguments, Handle (ArgumentReader::*read)()) {
  ArgumentReader in(mesh, arguments, Op::info.syntax);
  const Op op{{(in.*read)()}};
  return in.result(op);
}

template <class Op>
struct OnVertex {
  Vertex vertex;

  static Parsed<Op> parse(const Mesh& mesh, std::span<const std::string_view> arguments) {
    return parse_one<Op>(mesh, arguments, &ArgumentReader::vertex);
  }
  static Op at(const Mesh&, const OpTarget& target) { return {{target.vertex}}; }
  std::string command(const Mesh& mesh) const { return std::string(Op::info.id) + " " + name_of(mesh, vertex); }
  std::vector<Reason> warnings(const Mesh&) const { return {}; }
};

template <class Op>
struct OnHalfedge {
  Halfedge halfedge;

  static Parsed<Op> parse(const Mesh& mesh, std::span<const std::string_view> arguments) {
    return parse_one<Op>(mesh, arguments, &ArgumentReader::halfedge);
  }
  static Op at(const Mesh&, const OpTarget& target) { return {{target.halfedge}}; }
  std::string command(const Mesh& mesh) const { return std::string(Op::info.id) + " " + name_of(mesh, halfedge); }
  std::vector<Reason> warnings(const Mesh&) const { return {}; }
};

template <class Op>
struct OnFace {
  Face face;

  static Parsed<Op> parse(const Mesh& mesh, std::span<const std::string_view> arguments) {
    return parse_one<Op>(mesh, arguments, &ArgumentReader::face);
  }
  static Op at(const Mesh&, const OpTarget& target) { return {{target.face}}; }
  std::string command(const Mesh& mesh) const { return std::string(Op::info.id) + " " + name_of(mesh, face); }
  std::vector<Reason> warnings(const Mesh&) const { return {}; }
};

}  // namespace ryosen
