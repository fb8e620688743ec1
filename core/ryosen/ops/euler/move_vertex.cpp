#include "ryosen/ops/euler/move_vertex.h"

#include <cassert>

#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/face_polygon.h"
#include "ryosen/mesh/faces_at.h"
#include "ryosen/ops/parameters/member_values.h"
#include "ryosen/ops/rules/face_geometry.h"

namespace ryosen {

namespace {

using namespace parameters;

constexpr OpParameter move_vertex_parameters[] = {
    with_words({"vertex", "Vertex", "頂点", "the vertex that is moved, with its copies", "複製とともに動かす頂点"},
               required(vertex<&MoveVertex::vertex>("vN"))),
    with_words({"to", "Position", "座標", "where it moves", "移動先の座標"},
               required(position<&MoveVertex::position>()))};

}  // namespace

constinit const OpInfo MoveVertex::info{.id = "move_vertex",
                                        .name_en = "Move vertex",
                                        .name_ja = "頂点移動",
                                        .line = {.lists = {move_vertex_parameters}},
                                        .help_en = "moves a vertex and all its copies to a place",
                                        .help_ja = "頂点をそのすべての複製とともに移動する",
                                        .target = OpTargetKind::none,
                                        .group = OpGroup::euler,
                                        .aliases = "move",
                                        .topology = Topology::kept};

MoveVertex MoveVertex::at(const Mesh& mesh, const OpTarget& target) {
  return {target.vertex, is_there(mesh, target.vertex) ? mesh.position(target.vertex) : glm::dvec3()};
}

Verdict MoveVertex::check(const Mesh& mesh) const {
  Verdict verdict;
  is_gone(mesh, vertex, verdict);
  return verdict;
}

std::vector<Reason> MoveVertex::warnings(const Mesh& mesh) const {
  ShapeDoubts shape;
  FacePolygon polygon;
  for_each_face_at(mesh, vertex, [&](Face f) {
    polygon.read(mesh, f);
    const FaceGeometry before(polygon.keyhole_walk());
    polygon.move(mesh, vertex, position);
    shape.compare(before, FaceGeometry(polygon.keyhole_walk()), f);
  });
  std::vector<Reason> found;
  shape.add_to(found);
  return found;
}

OpEffect MoveVertex::apply(Edit& edit) const {
  assert(check(edit.mesh()).legal());
  move_point(edit, vertex, position);
  OpEffect effect;
  for_each_face_at(edit.mesh(), vertex, [&](Face f) { effect.changed.push_back(f); });
  return effect;
}

}  // namespace ryosen
