#include "tests/fuzz/any_op.h"

#include <array>
#include <limits>

#include "ryosen/base/number_text.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/ops/rules/surgery.h"

namespace ryosen::fuzz {
namespace {

constexpr std::size_t far_away = 1u << 20;

// Mostly a slot of the mesh, live or dead; now and then none, the next slot, or one far past the end.
template <class Handle>
Handle any_slot(std::uint32_t slots, Bytes& bytes) {
  const std::size_t b = bytes.byte();
  if (b == 255) return Handle();
  if (b == 254) return Handle(slots);
  if (b == 253) return Handle(far_away);
  return slots == 0 ? Handle() : Handle(b % slots);
}

double any_number(Bytes& bytes) {
  constexpr std::array odd{0.0, -0.0, 1.0, -1.0, 0.5, 1e308, -1e308, 5e-324, 1e-300, 1e154, 3.0, -0.25};
  const std::size_t b = bytes.byte();
  return b < odd.size() ? odd[b] : static_cast<double>(b) / 64 - 2;
}

std::string any_name(const Mesh& mesh, Bytes& bytes) {
  const auto number = [&] { return std::to_string(bytes.below(40)); };
  // In an order that does not depend on the compiler.
  const std::size_t kind = bytes.below(10);
  const std::string a = number(), b = kind >= 3 && kind <= 7 ? number() : "",
                    c = kind == 4 || kind == 5 ? number() : "";
  switch (kind) {
    case 0:
      return a;
    case 1:
      return "v" + a;
    case 2:
      return "f" + a;
    case 3:
      return a + "-" + b;
    case 4:
      return a + "-" + b + "@f" + c;
    case 5:
      return "~" + a + "-" + b + "@f" + c;
    case 6:
      return (bytes.coin() ? "h" : "e") + a;
    case 7:
      return "v" + a + "@f" + b;
    case 8: {
      const Halfedge h = any_halfedge(mesh, bytes);
      return h && mesh.exists(h) && mesh.is_alive(h) ? name_of(mesh, h) : "-";
    }
    default:
      return bytes.coin() ? format_double(any_number(bytes)) : format_place(any_place(mesh, bytes));
  }
}

// A line that follows the words of the syntax: what looks like an edge, a face, a place becomes one.
std::string any_line(const Mesh& mesh, const OpInfo& info, Bytes& bytes) {
  std::string line(info.id);
  const std::size_t words = bytes.below(5);
  for (std::size_t i = 0; i < words; ++i) line += " " + any_name(mesh, bytes);
  constexpr std::array endings{"", " back", " start", " mid", " -", " end", " ;", " 1,2,3"};
  return line + endings[bytes.below(endings.size())];
}

OpTarget any_target(const Mesh& mesh, Bytes& bytes) {
  OpTarget target;
  const std::size_t which = bytes.below(5);
  if (which != 1 && which != 2) target.halfedge = any_halfedge(mesh, bytes);
  if (which != 0 && which != 2) target.vertex = any_vertex(mesh, bytes);
  if (which != 0 && which != 1) target.face = any_face(mesh, bytes);
  target.along = static_cast<double>(bytes.byte()) / 255;
  return target;
}

// A halfedge that arrives at v: at a gap if it has any, else anywhere; now and then just any.
Halfedge any_into(const Mesh& mesh, Vertex v, Bytes& bytes) {
  const std::size_t b = bytes.byte();
  if (!v || !mesh.exists(v) || !mesh.is_alive(v) || b >= 250) return any_halfedge(mesh, bytes);
  if (mesh.is_isolated(v)) return Halfedge();
  std::vector<Halfedge> into = gaps_at(mesh, v);
  if (into.empty())
    for (Halfedge h : outgoing(mesh, v)) into.push_back(twin(h));
  return into[b % into.size()];
}

// Two corners of one face, as a rule.
std::pair<Halfedge, Halfedge> any_corners(const Mesh& mesh, Bytes& bytes) {
  const Face f = any_face(mesh, bytes);
  if (!f || !mesh.exists(f) || !mesh.is_alive(f) || bytes.byte() >= 250)
    return {any_halfedge(mesh, bytes), any_halfedge(mesh, bytes)};
  std::vector<Halfedge> corners;
  for (Halfedge h : halfedges_around(mesh, f)) corners.push_back(h);
  const Halfedge a = corners[bytes.byte() % corners.size()];
  return {a, corners[bytes.byte() % corners.size()]};
}

Element any_element(const Mesh& mesh, Bytes& bytes) {
  switch (bytes.below(3)) {
    case 0:
      return any_vertex(mesh, bytes);
    case 1:
      return any_face(mesh, bytes);
    default:
      return edge(any_halfedge(mesh, bytes));
  }
}

// Members are known by their names, so a new operator needs no word here as long as it calls them like the others.
template <class Op>
void fill(Op& op, const Mesh& mesh, Bytes& bytes) {
  if constexpr (requires { op.halfedge; }) op.halfedge = any_halfedge(mesh, bytes);
  if constexpr (requires { op.vertex; }) {
    if (!requires { op.halfedge; } || bytes.coin()) op.vertex = any_vertex(mesh, bytes);
  }
  if constexpr (requires { op.face; }) op.face = any_face(mesh, bytes);
  if constexpr (requires { op.element; }) op.element = any_element(mesh, bytes);
  if constexpr (requires { op.back; }) op.back = bytes.coin();
  if constexpr (requires { op.along; }) op.along = static_cast<double>(bytes.byte()) / 255;
  if constexpr (requires { op.place; }) {
    constexpr std::size_t places = requires { Op::Place::automatic; }
    ? 5 : 3;
    op.place = static_cast<decltype(op.place)>(bytes.below(5) % places);
  }
  if constexpr (
      requires { op.position; } && !requires { op.place; })
    op.position = any_place(mesh, bytes);
  if constexpr (requires { op.target; }) {
    if (bytes.coin()) op.target = any_place(mesh, bytes);
  }
  if constexpr (requires { op.distance; }) {
    if (bytes.coin()) op.distance = any_number(bytes);
  }
  if constexpr (requires { op.offset; }) {
    if (bytes.coin()) op.offset = any_place(mesh, bytes);
  }
  if constexpr (requires { op.left; }) {
    op.left = any_halfedge(mesh, bytes);
    op.right = any_halfedge(mesh, bytes);
    // Mostly two spokes of the vertex.
    if (op.left && mesh.exists(op.left) && mesh.is_alive(op.left) && bytes.byte() < 250) {
      op.vertex = mesh.from(op.left);
      const std::size_t steps = bytes.below(9);
      op.right = op.left;
      for (std::size_t i = 0; i < steps; ++i) op.right = mesh.counter_clockwise(op.right);
      if (steps == 8) op.right = Halfedge();
    }
  }
  if constexpr (requires { op.a; }) {
    op.a = any_vertex(mesh, bytes);
    op.b = any_vertex(mesh, bytes);
  }
  if constexpr (requires { op.first; }) {
    if (bytes.coin()) {
      op.a = op.b = Vertex();
      op.first = any_halfedge(mesh, bytes);
      op.second = any_halfedge(mesh, bytes);
    }
  }
  if constexpr (
      requires { op.into_a; } && requires { op.a; }) {
    op.into_a = any_into(mesh, op.a, bytes);
    op.into_b = any_into(mesh, op.b, bytes);
  } else if constexpr (requires { op.into_a; }) {
    std::tie(op.into_a, op.into_b) = any_corners(mesh, bytes);
  }
  if constexpr (requires { op.faces; })
    for (std::size_t n = bytes.below(4); n > 0; --n) op.faces.push_back(any_face(mesh, bytes));
  if constexpr (requires { op.corners; })
    for (std::size_t n = bytes.below(7); n > 0; --n) op.corners.push_back(any_vertex(mesh, bytes));
}

template <std::size_t... I>
AnyOp filled(std::size_t place, const Mesh& mesh, Bytes& bytes, std::index_sequence<I...>) {
  AnyOp op;
  ((I == place ? fill(op.emplace<I>(), mesh, bytes) : void()), ...);
  return op;
}

std::string slot(Vertex v) { return v ? "v" + std::to_string(v.index) : "none"; }
std::string slot(Halfedge h) { return h ? "h" + std::to_string(h.index) : "none"; }
std::string slot(Face f) { return f ? "f" + std::to_string(f.index) : "none"; }

}  // namespace

Vertex any_vertex(const Mesh& mesh, Bytes& bytes) { return any_slot<Vertex>(mesh.vertex_slots(), bytes); }
Halfedge any_halfedge(const Mesh& mesh, Bytes& bytes) { return any_slot<Halfedge>(mesh.halfedge_slots(), bytes); }
Face any_face(const Mesh& mesh, Bytes& bytes) { return any_slot<Face>(mesh.face_slots(), bytes); }

glm::dvec3 any_place(const Mesh& mesh, Bytes& bytes) {
  if (bytes.below(4) == 0) {
    const Vertex v = any_vertex(mesh, bytes);
    if (v && mesh.exists(v)) return mesh.position(v);
  }
  return {any_number(bytes), any_number(bytes), any_number(bytes)};
}

std::optional<AnyOp> any_op(const Mesh& mesh, Bytes& bytes, std::string& line) {
  constexpr std::size_t count = std::variant_size_v<AnyOp>;
  const std::size_t way = bytes.below(8), place = bytes.below(count);
  const OpInfo& info = all_ops()[place];
  if (way == 0) {
    line = any_line(mesh, info, bytes);
    return parse_line(mesh, line).op;
  }
  if (way == 1) return op_at(mesh, info.id, any_target(mesh, bytes));
  return filled(place, mesh, bytes, std::make_index_sequence<count>());
}

std::string by_slots(const AnyOp& any) {
  std::string text(info_of(any).id);
  std::visit(
      [&](const auto& op) {
        if constexpr (requires { op.halfedge; }) text += " halfedge " + slot(op.halfedge);
        if constexpr (requires { op.vertex; }) text += " vertex " + slot(op.vertex);
        if constexpr (requires { op.face; }) text += " face " + slot(op.face);
        if constexpr (requires { op.element; })
          text +=
              " element " + std::to_string(static_cast<int>(op.element.kind)) + ":" + std::to_string(op.element.index);
        if constexpr (requires { op.back; }) text += op.back ? " back" : "";
        if constexpr (requires { op.along; }) text += " along " + format_double(op.along);
        if constexpr (requires { op.left; }) text += " left " + slot(op.left) + " right " + slot(op.right);
        if constexpr (requires { op.a; }) text += " a " + slot(op.a) + " b " + slot(op.b);
        if constexpr (requires { op.first; }) text += " first " + slot(op.first) + " second " + slot(op.second);
        if constexpr (requires { op.into_a; }) text += " into " + slot(op.into_a) + " " + slot(op.into_b);
        if constexpr (requires { op.faces; })
          for (Face f : op.faces) text += " " + slot(f);
        if constexpr (requires { op.corners; })
          for (Vertex v : op.corners) text += " " + slot(v);
      },
      any);
  return text;
}

}  // namespace ryosen::fuzz
