#include "ryosen/ops/collapse_edge.h"

#include <algorithm>
#include <cassert>
#include <glm/geometric.hpp>

#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/face_polygon.h"
#include "ryosen/ops/parameters/member_values.h"
#include "ryosen/ops/rules/collapse_links.h"
#include "ryosen/ops/rules/corner_values.h"
#include "ryosen/ops/rules/face_geometry.h"

namespace ryosen {

namespace {

using namespace parameters;

constexpr OpParameter collapse_parameters[] = {
    missing(required(edge<&CollapseEdge::halfedge>("A-B")), "an edge A-B is missing", "稜線 A-B の指定がありません"),
    expecting(optional(word<&CollapseEdge::place, CollapseEdge::Place::start>("start"),
                       word<&CollapseEdge::place, CollapseEdge::Place::end>("end"),
                       word<&CollapseEdge::place, CollapseEdge::Place::middle>("mid"),
                       position_if<&CollapseEdge::target, &CollapseEdge::place, CollapseEdge::Place::point>()),
              "start, end, mid or X,Y,Z", "start、end、mid、X,Y,Z のいずれかを")};

}  // namespace

constinit const OpInfo CollapseEdge::info{
    .id = "collapse",
    .name_en = "Collapse edge",
    .name_ja = "稜線削除",
    .line = {.lists = {collapse_parameters}},
    .help_en = "merges A into B; B keeps its number and, by default, its position",
    .help_ja = "A が消え、B が番号と（指定がなければ）位置を保つ",
    .key = 'C',
    .target = OpTargetKind::edge,
    .group = OpGroup::join,
    .topology = Topology::kept,
    .in_series = collapses_in_series};

namespace {

constexpr std::size_t usual_valence = 12;  // for reserving lists

}  // namespace

CollapseEdge CollapseEdge::at(const Mesh&, const OpTarget& target) {
  // The end nearer to the pointer is a; over the third at that end the other one comes to it.
  const bool is_at_start = target.along <= 0.5;
  const double from_end = is_at_start ? target.along : 1 - target.along;
  if (!target.is_small && from_end < 1.0 / 3)
    return {is_at_start ? twin(target.halfedge) : target.halfedge, Place::automatic};
  return {is_at_start ? target.halfedge : twin(target.halfedge), Place::middle};
}

glm::dvec3 CollapseEdge::position(const Mesh& mesh) const {
  const glm::dvec3 &a = mesh.position(mesh.from(halfedge)), &b = mesh.position(mesh.to(halfedge));
  switch (place) {
    case Place::automatic:
      return mesh.position(mesh.to(directed(mesh)));
    case Place::start:
      return a;
    case Place::end:
      return b;
    case Place::middle:
      return point_between(a, b, 0.5);
    case Place::point:
      break;
  }
  return target;
}

std::vector<Reason> CollapseEdge::warnings(const Mesh& mesh) const {
  const Halfedge h = directed(mesh);
  const glm::dvec3 place_after = position(mesh);
  std::vector<Reason> found;
  if (is_seam(mesh, h)) found.push_back({Rule::seam, {edge(h)}});
  const Vertex gone = mesh.from(h), kept = mesh.to(h);
  ShapeDoubts shape;
  FacePolygon polygon;
  const auto look = [&](Face f) {
    const bool is_at_edge = f == mesh.face(h) || f == mesh.face(twin(h));
    if (is_at_edge && corner_count(mesh, f) == 3) return;  // vanishes
    polygon.read(mesh, f);
    const FaceGeometry before(polygon.keyhole_walk());
    polygon.move(mesh, gone, place_after);
    polygon.move(mesh, kept, place_after);
    shape.compare(before, FaceGeometry(polygon.keyhole_walk()), f);
  };
  for (Halfedge g : outgoing(mesh, gone))
    if (!mesh.is_outside(g)) look(mesh.face(g));
  for_each_copy(mesh, kept, [&](Vertex copy) {
    for (Halfedge k : outgoing(mesh, copy))
      if (!mesh.is_outside(k) && mesh.face(k) != mesh.face(h) && mesh.face(k) != mesh.face(twin(h))) look(mesh.face(k));
  });
  shape.add_to(found);
  return found;
}

OpEffect CollapseEdge::apply(Edit& edit) const {
  const Mesh& m = edit.mesh();
  assert(check(m).legal());
  const Halfedge h = directed(m), o = twin(h);
  const Vertex gone = m.from(h), kept = m.to(h);
  OpEffect effect;
  effect.deleted.reserve(6);
  effect.deleted.push_back(gone);
  effect.deleted.push_back(edge(h));
  std::optional<glm::dvec3> moved;
  if (place != Place::automatic) moved = position(m);
  if (!corner_attributes(m).empty())
    blend_corners(edit, h, moved ? closest_parameter(m.position(gone), m.position(kept), *moved) : 1);
  Halfedge hold = m.halfedge(kept);
  const Halfedge some = take_edge_out(edit, h, effect);
  if (hold == o) hold = some;
  // The remaining vertex must store a boundary halfedge, if it has one.
  effect.changed.reserve(usual_valence);
  Halfedge g = some;
  do {
    if (m.from(g) != kept) edit.set_from(g, kept);
    if (m.is_outside(g))
      hold = g;
    else
      effect.changed.push_back(m.face(g));
    g = m.counter_clockwise(g);
  } while (g != some);
  edit.set_halfedge(kept, hold);
  edit.remove(gone);
  if (!moved) return effect;
  move_point(edit, kept, *moved);
  for_each_copy(m, kept, [&](Vertex copy) {
    if (copy == kept) return;
    for (Halfedge around : outgoing(m, copy))
      if (!m.is_outside(around)) effect.changed.push_back(m.face(around));
  });
  return effect;
}

}  // namespace ryosen
