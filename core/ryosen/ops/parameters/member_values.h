// Values of an operator's line that a member of the operator keeps.
//
//   with_words({"edge", "Edge", "稜線", "the edge that is turned", "回す稜線"},
//              required(edge<&SwapEdge::halfedge>("A-B")))
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "ryosen/base/element.h"
#include "ryosen/ops/parameters/op_line.h"
#include "ryosen/ops/parameters/op_parameter.h"

namespace ryosen::parameters {

template <auto Member>
struct Access;
template <class Operator, class Type, Type Operator::*Member>
struct Access<Member> {
  using Op = Operator;
  using Value = Type;
  static Value& of(void* op) { return static_cast<Op*>(op)->*Member; }
  static const Value& of(const void* op) { return static_cast<const Op*>(op)->*Member; }
};

template <class Value>
void keep(Value& member, const Value& value) {
  member = value;
}
inline void keep(Element& member, Element value) { member = value; }
template <class Value>
void keep(std::vector<Value>& member, const Value& value) {
  member.push_back(value);
}

// Gives a member what it holds in an operator that was told nothing.
template <auto Member>
void clear(void* op) {
  Access<Member>::of(op) = (typename Access<Member>::Op{}).*Member;
}

// Whether a member holds a value; an Element one of this kind.
template <auto Member, Element::Kind kind>
bool is_held(const void* op) {
  const auto& member = Access<Member>::of(op);
  if constexpr (std::is_same_v<typename Access<Member>::Value, Element>)
    return member.index != no_index && member.kind == kind;
  else if constexpr (requires { member.empty(); })
    return !member.empty();
  else
    return static_cast<bool>(member);
}

// Appends the names of all values that a member holds, each behind a blank.
template <auto Member, class NameOf>
void print_each(const void* op, std::string& line, NameOf name_of) {
  const auto& member = Access<Member>::of(op);
  if constexpr (requires { member.begin(); })
    for (const auto& each : member) line += " " + name_of(each);
  else
    line += " " + name_of(member);
}

// The value itself, or that of an optional that has one.
template <class Value>
const Value& value_of(const Value& value) {
  return value;
}
template <class Value>
const Value& value_of(const std::optional<Value>& value) {
  return *value;
}

enum class VertexName { of_point, of_copy };

template <auto Member, VertexName Name, Vertex (ArgumentReader::*Read)()>
constexpr OpValue vertex_value(std::string_view called) {
  return {.kind = OpValueKind::vertex,
          .called = called,
          .read = [](ArgumentReader& in, void* op) { keep(Access<Member>::of(op), (in.*Read)()); },
          .is_held = is_held<Member, Element::Kind::vertex>,
          .print =
              [](const Mesh& mesh, const void* op, std::string& line) {
                print_each<Member>(op, line, [&](const auto& v) {
                  if constexpr (Name == VertexName::of_copy)
                    return name_of_copy(mesh, v);
                  else
                    return name_of(mesh, v);
                });
              }};
}

// A vertex that stands for its point, and is printed so.
template <auto Member>
constexpr OpValue vertex(std::string_view called) {
  return vertex_value<Member, VertexName::of_point, &ArgumentReader::vertex>(called);
}
// A vertex that is printed as a copy of its point; without a face a name means the point's first one.
template <auto Member>
constexpr OpValue copy(std::string_view called) {
  return vertex_value<Member, VertexName::of_copy, &ArgumentReader::vertex>(called);
}
// The same; where the point has several copies, the name must tell which.
template <auto Member>
constexpr OpValue one_copy(std::string_view called) {
  return vertex_value<Member, VertexName::of_copy, &ArgumentReader::copy>(called);
}
// A further value of a list that another value prints.
constexpr OpValue unprinted(OpValue value) {
  value.print = nullptr;
  return value;
}

template <auto Member>
constexpr OpValue face(std::string_view called) {
  return {.kind = OpValueKind::face,
          .called = called,
          .read = [](ArgumentReader& in, void* op) { keep(Access<Member>::of(op), in.face()); },
          .is_held = is_held<Member, Element::Kind::face>,
          .print =
              [](const Mesh& mesh, const void* op, std::string& line) {
                print_each<Member>(op, line, [&](const auto& f) { return name_of(mesh, f); });
              }};
}

// An edge in the direction of its name; an Element has no direction.
template <auto Member, auto Find = find_edge>
constexpr OpValue edge(std::string_view called) {
  using Kept = Access<Member>;
  constexpr bool is_element = std::is_same_v<typename Kept::Value, Element>;
  OpValue value{.kind = OpValueKind::edge, .called = called};
  value.read = [](ArgumentReader& in, void* op) {
    if constexpr (is_element)
      Kept::of(op) = ryosen::edge(in.read(Find));
    else
      keep(Kept::of(op), in.read(Find));
  };
  value.is_held = is_held<Member, Element::Kind::edge>;
  value.print = [](const Mesh& mesh, const void* op, std::string& line) {
    print_each<Member>(op, line, [&](const auto& e) { return name_of(mesh, e); });
  };
  if constexpr (std::is_same_v<typename Kept::Value, Halfedge>) {
    value.halfedge = [](const void* op) { return Kept::of(op); };
  } else if constexpr (!is_element) {  // a list of halfedges: their names keep the direction
    value.print = [](const Mesh& mesh, const void* op, std::string& line) {
      print_each<Member>(op, line, [&](Halfedge h) {
        return h && mesh.exists(h) && mesh.is_alive(h) ? name_to_choose(mesh, h) : name_of(mesh, h);
      });
    };
    value.halfedge = [](const void* op) { return Kept::of(op).size() == 1 ? Kept::of(op)[0] : Halfedge(); };
  }
  return value;
}

// An element that the operator reads and prints itself.
constexpr OpValue element(OpValueKind kind, std::string_view called) { return {.kind = kind, .called = called}; }

// A number; a plain double is printed only if it differs from its default.
template <auto Member>
constexpr OpValue number(std::string_view called) {
  using Kept = Access<Member>;
  return {.kind = OpValueKind::number,
          .called = called,
          .read = [](ArgumentReader& in, void* op) { Kept::of(op) = in.number(); },
          .is_held =
              [](const void* op) {
                if constexpr (std::is_same_v<typename Kept::Value, double>)
                  return Kept::of(op) != (typename Kept::Op{}).*Member;
                else
                  return Kept::of(op).has_value();
              },
          .print = [](const Mesh&, const void* op,
                      std::string& line) { line += " " + format_double(value_of(Kept::of(op))); },
          .clear = clear<Member>};
}

template <auto Member>
constexpr OpValue position(std::string_view called = "X,Y,Z") {
  using Kept = Access<Member>;
  return {.kind = OpValueKind::position,
          .called = called,
          .read = [](ArgumentReader& in, void* op) { Kept::of(op) = in.place(); },
          .is_held =
              [](const void* op) {
                if constexpr (std::is_same_v<typename Kept::Value, glm::dvec3>)
                  return true;
                else
                  return Kept::of(op).has_value();
              },
          .print = [](const Mesh&, const void* op,
                      std::string& line) { line += " " + format_place(value_of(Kept::of(op))); },
          .clear = clear<Member>,
          .set = [](void* op, const glm::dvec3& position) { Kept::of(op) = position; }};
}
// A position that also gives member `Told` a value, and is printed only if it has that value.
template <auto Member, auto Told, auto Value>
constexpr OpValue position_if(std::string_view called = "X,Y,Z") {
  OpValue value = position<Member>(called);
  value.read = [](ArgumentReader& in, void* op) {
    Access<Told>::of(op) = Value;
    Access<Member>::of(op) = in.place();
  };
  value.is_held = [](const void* op) { return Access<Told>::of(op) == Value; };
  return value;
}

// A word that gives a member a value.
template <auto Member, auto Value>
constexpr OpValue word(std::string_view called) {
  using Kept = Access<Member>;
  return {.kind = OpValueKind::word,
          .called = called,
          .read =
              [](ArgumentReader& in, void* op) {
                in.skip();
                Kept::of(op) = Value;
              },
          .is_held = [](const void* op) { return Kept::of(op) == Value; }};
}

// A value as a list of choices calls it.
constexpr OpValue named(std::string_view en, std::string_view ja, OpValue value) {
  value.name_en = en;
  value.name_ja = ja;
  return value;
}

template <class... Values>
constexpr OpParameter required(Values... values) {
  return {.need = OpParameter::Need::required, .values = {values...}};
}
template <class... Values>
constexpr OpParameter optional(Values... values) {
  return {.need = OpParameter::Need::optional, .values = {values...}};
}
constexpr OpParameter list(OpValue value, std::string_view more = "") {
  return {.need = OpParameter::Need::list, .values = {value}, .more = more};
}
constexpr OpParameter expecting(OpParameter parameter, std::string_view en, std::string_view ja) {
  parameter.expected_en = en;
  parameter.expected_ja = ja;
  return parameter;
}
constexpr OpParameter dragged(const OpDrag& drag, OpParameter parameter) {
  parameter.drag = &drag;
  return parameter;
}
constexpr OpParameter missing(OpParameter parameter, std::string_view en, std::string_view ja) {
  parameter.missing_en = en;
  parameter.missing_ja = ja;
  return parameter;
}

}  // namespace ryosen::parameters
