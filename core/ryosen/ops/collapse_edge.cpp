#include "ryosen/ops/collapse_edge.h"

#include <algorithm>
#include <cassert>
#include <glm/geometric.hpp>

#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/face_polygon.h"
#include "ryosen/ops/lines/arguments.h"
#include "ryosen/ops/rules/collapse_links.h"
#include "ryosen/ops/rules/corner_values.h"
#include "ryosen/ops/rules/face_geometry.h"

namespace ryosen {

namespace {

constexpr std::size_t usual_valence = 12;  // for reserving lists

}  // namespace

Parsed<CollapseEdge> CollapseEdge::parse(const Mesh& mesh, std::span<const std::string_view> arguments) {
  Parsed<CollapseEdge> out;
  const auto h = parse_edge_argument(mesh, arguments, out);
  if (!h) return out;
  CollapseEdge op{*h};
  if (arguments.size() >= 2) {
    const std::string_view word = arguments[1];
    const auto p = parse_place(word);
    if (word == "start")
      op.place = Place::start;
    else if (word == "end")
      op.place = Place::end;
    else if (word == "mid")
      op.place = Place::middle;
    else if (p)
      op.place = Place::point, op.target = *p;
    else
      return malformed_argument<CollapseEdge>(word,
                                              {"start, end, mid or X,Y,Z", "start、end、mid、X,Y,Z のいずれかを"});
  }
  if (arguments.size() > 2) return malformed_argument<CollapseEdge>(arguments[2]);
  out.op = op;
  return out;
}

CollapseEdge CollapseEdge::at(const Mesh&, const OpTarget& target) {
  // The end nearer to the pointer is a; over the third at that end the other one comes to it.
  const bool is_at_start = target.along <= 0.5;
  const double from_end = is_at_start ? target.along : 1 - target.along;
  if (!target.is_small && from_end < 1.0 / 3)
    return {is_at_start ? twin(target.halfedge) : target.halfedge, Place::automatic};
  return {is_at_start ? target.halfedge : twin(target.halfedge), Place::middle};
}

std::string CollapseEdge::command(const Mesh& mesh) const {
  std::string text = "collapse " + name_of(mesh, halfedge);
  switch (place) {
    case Place::automatic:
      return text;
    case Place::start:
      return text + " start";
    case Place::end:
      return text + " end";
    case Place::middle:
      return text + " mid";
    case Place::point:
      break;
  }
  return text + " " + format_place(target);
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
