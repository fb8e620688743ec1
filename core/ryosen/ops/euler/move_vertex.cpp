#include "ryosen/ops/euler/move_vertex.h"

#include <cassert>

#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/face_polygon.h"
#include "ryosen/ops/lines/arguments.h"
#include "ryosen/ops/rules/face_geometry.h"

namespace ryosen {

Parsed<MoveVertex> MoveVertex::parse(const Mesh& mesh, std::span<const std::string_view> arguments) {
  ArgumentReader in(mesh, arguments, info.syntax);
  const Vertex v = in.vertex();
  const MoveVertex op{v, in.place()};
  return in.result(op);
}

MoveVertex MoveVertex::at(const Mesh& mesh, const OpTarget& target) {
  return {target.vertex, is_there(mesh, target.vertex) ? mesh.position(target.vertex) : glm::dvec3()};
}

std::string MoveVertex::command(const Mesh& mesh) const {
  return "move_vertex " + name_of(mesh, vertex) + " " + format_place(position);
}

Verdict MoveVertex::check(const Mesh& mesh) const {
  Verdict verdict;
  is_gone(mesh, vertex, verdict);
  return verdict;
}

std::vector<Reason> MoveVertex::warnings(const Mesh& mesh) const {
  ShapeDoubts shape;
  FacePolygon polygon;
  for_each_copy(mesh, vertex, [&](Vertex copy) {
    for (Face f : faces_around(mesh, copy)) {
      if (!f) continue;
      polygon.read(mesh, f);
      const FaceGeometry before(polygon.keyhole_walk());
      polygon.move(mesh, vertex, position);
      shape.compare(before, FaceGeometry(polygon.keyhole_walk()), f);
    }
  });
  std::vector<Reason> found;
  shape.add_to(found);
  return found;
}

OpEffect MoveVertex::apply(Edit& edit) const {
  assert(check(edit.mesh()).legal());
  move_point(edit, vertex, position);
  OpEffect effect;
  for_each_copy(edit.mesh(), vertex, [&](Vertex copy) {
    for (Face f : faces_around(edit.mesh(), copy))
      if (f) effect.changed.push_back(f);
  });
  return effect;
}

}  // namespace ryosen
