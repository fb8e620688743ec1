#include "ryosen/ops/collapse_edge.h"

#include <algorithm>
#include <cassert>
#include <glm/geometric.hpp>

#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/face_polygon.h"
#include "ryosen/ops/lines/arguments.h"
#include "ryosen/ops/rules/corner_values.h"
#include "ryosen/ops/rules/face_geometry.h"

namespace ryosen {

namespace {

constexpr std::size_t usual_valence = 12;  // for reserving lists

// Interpolates corner values around the edge: corners in the same chart (up to seams) as a side take its value at
// `along`.
void blend_corners(Edit& edit, Halfedge h, double along) {
  CornerWriter corners(edit);
  const Mesh& m = edit.mesh();
  for (std::size_t k = 0; k < corners.count(); ++k) {
    struct Chart {
      std::uint32_t gone, kept, blended;
    };
    std::vector<Chart> charts;
    for (Halfedge side : {h, twin(h)}) {
      if (m.is_outside(side)) continue;
      const Halfedge at_gone = side == h ? side : m.next(side), at_kept = side == h ? m.next(side) : side;
      const std::uint32_t gone = corners.index(k, at_gone), kept = corners.index(k, at_kept);
      if (std::none_of(charts.begin(), charts.end(), [&](const Chart& c) { return c.gone == gone && c.kept == kept; }))
        charts.push_back({gone, kept, corners.blend(k, gone, kept, along)});
    }
    const auto update = [&](Vertex v, std::uint32_t Chart::*old) {
      for (Halfedge corner : outgoing(m, v)) {
        if (m.is_outside(corner)) continue;
        for (const Chart& chart : charts) {
          if (chart.*old != corners.index(k, corner)) continue;
          corners.set(k, corner, chart.blended);
          break;
        }
      }
    };
    update(m.from(h), &Chart::gone);
    update(m.to(h), &Chart::kept);
  }
}

// Removes a triangle that has become a face with two sides: `going` starts or ends at the removed vertex, `staying` is
// the other side. `staying` replaces the twin of `going` in the adjacent face or boundary loop.
void close_two_gon(Edit& edit, Halfedge going, Halfedge staying, OpEffect& effect) {
  const Mesh& m = edit.mesh();
  const Halfedge beyond = twin(going);
  const Face dropped = m.face(staying), face = m.face(beyond);
  const Vertex apex = m.from(going) == m.to(staying) ? m.from(going) : m.to(going);
  const Halfedge from_apex = m.from(going) == apex ? going : beyond;
  CornerWriter corners(edit);
  for (std::size_t k = 0; k < corners.count(); ++k) corners.set(k, staying, corners.index(k, beyond));
  edit.connect(m.prev(beyond), staying);
  edit.connect(staying, m.next(beyond));
  edit.set_face(staying, face);
  if (face) replace_start(edit, face, beyond, staying);
  if (m.halfedge(apex) == from_apex) edit.set_halfedge(apex, m.from(staying) == apex ? staying : twin(staying));
  edit.remove(edge(going));
  edit.remove(dropped);
  effect.deleted.push_back(edge(going));
  effect.deleted.push_back(dropped);
}

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
  std::vector<Halfedge> around_gone;
  around_gone.reserve(usual_valence);
  for (Halfedge g : outgoing(m, gone)) around_gone.push_back(g);
  const auto is_plain_triangle = [&](Halfedge side) {
    return !m.is_outside(side) && is_triangle(m, side) && !m.has_rings(m.face(side));
  };
  const bool left_two_gon = is_plain_triangle(h), right_two_gon = is_plain_triangle(o);
  const Halfedge h_next = m.next(h), h_prev = m.prev(h), o_next = m.next(o), o_prev = m.prev(o);
  // A wire may have a free end, where its halves follow each other.
  const bool tip_kept = h_next == o, tip_gone = o_next == h;
  for (Halfedge side : {h, o}) {
    const Face f = m.face(side);
    if (f) replace_start(edit, f, side, m.next(side));
  }
  if (!tip_kept && !tip_gone) {
    edit.connect(h_prev, h_next);
    edit.connect(o_prev, o_next);
  } else {
    edit.connect(tip_kept ? h_prev : o_prev, tip_kept ? o_next : h_next);
  }
  for (Halfedge g : around_gone)
    if (g != h && !(left_two_gon && g == twin(h_prev)) && !(right_two_gon && g == o_next)) edit.set_from(g, kept);
  if (left_two_gon) close_two_gon(edit, h_prev, h_next, effect);
  if (right_two_gon) close_two_gon(edit, o_next, o_prev, effect);

  // The remaining vertex must store a boundary halfedge, if it has one. Beyond a free end of a wire there is none.
  const Halfedge some = tip_kept ? o_next : h_next;
  Halfedge hold = m.halfedge(kept) != o ? m.halfedge(kept) : some;
  if (!m.is_alive(hold) || m.from(hold) != kept) hold = some;
  effect.changed.reserve(usual_valence);
  Halfedge g = some;
  do {
    if (m.is_outside(g))
      hold = g;
    else
      effect.changed.push_back(m.face(g));
    g = m.counter_clockwise(g);
  } while (g != some);
  edit.set_halfedge(kept, hold);
  edit.remove(edge(h));
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
