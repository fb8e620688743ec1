#include "ryosen/ops/split_edge.h"

#include <algorithm>
#include <cassert>
#include <glm/geometric.hpp>

#include "ryosen/geometry/is_finite.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/rings.h"
#include "ryosen/ops/lines/arguments.h"
#include "ryosen/ops/rules/corner_values.h"
#include "ryosen/ops/rules/face_geometry.h"
#include "ryosen/ops/rules/sheets.h"

namespace ryosen {

namespace {

// The halfedges that one split cuts, from a copy of A to a copy of B, the one with the lowest face first.
std::vector<Halfedge> sheets_of(const Mesh& m, Halfedge h) {
  if (!is_cut_on_points(m, h)) return {h};
  std::vector<Halfedge> sheets = sheets_between(m, m.from(h), m.to(h));
  const auto lowest = [&](Halfedge s) { return std::min(m.face(s), m.face(twin(s))); };
  std::sort(sheets.begin(), sheets.end(), [&](Halfedge x, Halfedge y) { return lowest(x) < lowest(y); });
  return sheets;
}

bool is_triangle_side(const Mesh& m, Halfedge side) {
  return !m.is_outside(side) && is_triangle(m, side) && !m.has_rings(m.face(side));
}

// Cuts a triangle from the new vertex m to the third corner: `into` ends at m and `out` starts there. The part with A,
// the origin of the edge, keeps the face.
//
//            third                      part of A: a -> m -> third
//           /  |  \                     other:     m -> b -> third
//          a---m---b
Face cut_triangle(Edit& edit, Halfedge into, Halfedge out, bool origin_keeps, OpEffect& effect) {
  const Mesh& mesh = edit.mesh();
  const Face old = mesh.face(into);
  const Halfedge after_out = mesh.next(out), before_into = mesh.prev(into);
  const Vertex m = mesh.from(out), third = mesh.from(before_into);
  const Halfedge down = edit.add_edge(m, third), up = twin(down);  // down closes the part before m, up the other
  edit.connect(into, down);
  edit.connect(down, before_into);
  edit.connect(after_out, up);
  edit.connect(up, out);
  const Face fresh = edit.add_face(origin_keeps ? out : into);
  copy_face_values(edit, old, fresh);
  const Face before_m = origin_keeps ? old : fresh, after_m = origin_keeps ? fresh : old;
  for (Halfedge h : {into, down, before_into}) edit.set_face(h, before_m);
  for (Halfedge h : {out, after_out, up}) edit.set_face(h, after_m);
  // The new corner replaces the end that the old face lost.
  const Halfedge lost = origin_keeps ? after_out : into;
  if (origin_keeps && mesh.halfedge(old) == lost) edit.set_halfedge(old, down);
  if (!origin_keeps) {
    if (mesh.halfedge(old) == into)
      edit.set_halfedge(old, out);
    else if (mesh.halfedge(old) == before_into)
      edit.set_halfedge(old, up);
  }
  CornerWriter corners(edit);
  for (std::size_t k = 0; k < corners.count(); ++k) {
    corners.set(k, down, corners.index(k, out));
    corners.set(k, up, corners.index(k, before_into));
  }
  effect.created.push_back(edge(down));
  effect.created.push_back(fresh);
  return fresh;
}

// Inserts the vertex m into one sheet: h becomes a -> m, the new edge is m -> b.
Vertex cut_sheet(Edit& edit, Halfedge h, double along, const glm::dvec3& position, CutTriangles cut, OpEffect& effect) {
  const Mesh& mesh = edit.mesh();
  const Halfedge o = twin(h), h_next = mesh.next(h), o_prev = mesh.prev(o);
  const Vertex a = mesh.from(h), b = mesh.from(o);
  const bool cuts = cut == CutTriangles::yes;
  const bool cut_left = cuts && is_triangle_side(mesh, h), cut_right = cuts && is_triangle_side(mesh, o);
  const Vertex m = edit.add_vertex(position);
  blend_vertex_values(edit, a, b, along, m);
  const Halfedge fresh = edit.add_edge(m, b), fresh_twin = twin(fresh);
  effect.created.push_back(m);
  effect.created.push_back(edge(fresh));

  CornerWriter corners(edit);
  for (std::size_t k = 0; k < corners.count(); ++k) {
    if (!mesh.is_outside(h))
      corners.set(k, fresh, corners.blend(k, corners.index(k, h), corners.index(k, h_next), along));
    if (mesh.is_outside(o)) continue;
    corners.set(k, fresh_twin, corners.index(k, o));
    corners.set(k, o, corners.blend(k, corners.index(k, mesh.next(o)), corners.index(k, o), along));
  }
  edit.set_from(o, m);
  edit.connect(h, fresh);
  if (h_next == o) {  // a wire with a free end at b
    edit.connect(fresh, fresh_twin);
  } else {
    edit.connect(fresh, h_next);
    edit.connect(o_prev, fresh_twin);
  }
  edit.connect(fresh_twin, o);
  edit.set_face(fresh, mesh.face(h));
  edit.set_face(fresh_twin, mesh.face(o));
  if (mesh.halfedge(b) == o) edit.set_halfedge(b, fresh_twin);
  if (!mesh.is_outside(o)) replace_start(edit, mesh.face(o), o, fresh_twin);
  edit.set_halfedge(m, mesh.is_outside(o) ? o : fresh);

  for (Halfedge side : {h, o})
    if (!mesh.is_outside(side)) effect.changed.push_back(mesh.face(side));
  if (cut_left) effect.changed.push_back(cut_triangle(edit, h, fresh, true, effect));
  if (cut_right) effect.changed.push_back(cut_triangle(edit, fresh_twin, o, false, effect));
  return m;
}

}  // namespace

Parsed<SplitEdge> SplitEdge::parse(const Mesh& mesh, std::span<const std::string_view> arguments) {
  Parsed<SplitEdge> out;
  const auto h = parse_edge_argument(mesh, arguments, out);
  if (!h) return out;
  SplitEdge op{*h};
  if (arguments.size() >= 2) {
    const auto t = parse_double(arguments[1]);
    if (!t) {
      op.place = parse_place(arguments[1]);
      if (!op.place)
        return malformed_argument<SplitEdge>(arguments[1], {"a number t or X,Y,Z", "数 t または X,Y,Z を"});
    }
    op.along = t.value_or(op.along);
    const glm::dvec3 &a = mesh.position(mesh.from(*h)), &b = mesh.position(mesh.to(*h));
    if (is_finite(a) && is_finite(b) && t && !is_finite(point_between(a, b, *t)))
      return malformed_argument<SplitEdge>(
          arguments[1], {"a t that leaves the new vertex at a finite place", "新しい頂点の座標が有限になる t を"});
  }
  if (arguments.size() > 2) return malformed_argument<SplitEdge>(arguments[2]);
  out.op = op;
  return out;
}

std::string SplitEdge::command(const Mesh& mesh) const {
  const std::string line = "split " + name_of(mesh, halfedge);
  if (place) return line + " " + format_place(*place);
  return line + (along == 0.5 ? "" : " " + format_double(along));
}

Verdict SplitEdge::check(const Mesh& m) const {
  Verdict verdict;
  if (is_gone(m, halfedge, verdict)) return verdict;
  if (is_bridge(m, halfedge)) {
    verdict.refuse(Rule::loop, {edge(halfedge), m.face(halfedge)});
    return verdict;
  }
  std::vector<std::pair<Vertex, Face>> apexes;
  for (Halfedge sheet : sheets_of(m, halfedge))
    for (Halfedge side : {sheet, twin(sheet)})
      if (is_triangle_side(m, side)) apexes.emplace_back(point(m, m.from(m.prev(side))), m.face(side));
  std::sort(apexes.begin(), apexes.end());
  for (std::size_t i = 1; i < apexes.size(); ++i)
    if (apexes[i].first == apexes[i - 1].first)
      verdict.refuse(Rule::same_apex, {apexes[i].first, apexes[i - 1].second, apexes[i].second});
  return verdict;
}

std::vector<Reason> SplitEdge::warnings(const Mesh& m) const {
  const glm::dvec3 p = position(m);
  ShapeDoubts shape;
  for (Halfedge sheet : sheets_of(m, halfedge)) {
    for (Halfedge side : {sheet, twin(sheet)}) {
      if (!is_triangle_side(m, side)) continue;
      const glm::dvec3 &a = m.position(m.from(side)), &b = m.position(m.to(side));
      const glm::dvec3& third = m.position(m.from(m.prev(side)));
      const FaceGeometry before{{a, b, third}}, first{{a, p, third}}, second{{p, b, third}};
      if (before.is_degenerate()) continue;
      if (first.is_degenerate() || second.is_degenerate())
        shape.degenerate.push_back(m.face(side));
      else if (before.turns_against(first) || before.turns_against(second))
        shape.turned.push_back(m.face(side));
    }
  }
  std::vector<Reason> found;
  shape.add_to(found);
  if (!place) warn_of_place(halfedge, along, found);
  return found;
}

glm::dvec3 SplitEdge::position(const Mesh& m) const {
  return place ? *place : point_between(m.position(m.from(halfedge)), m.position(m.to(halfedge)), along);
}

double SplitEdge::blend(const Mesh& m) const {
  if (!place) return along;
  const glm::dvec3 way = m.position(m.to(halfedge)) - m.position(m.from(halfedge));
  const double share = glm::dot(*place - m.position(m.from(halfedge)), way) / glm::dot(way, way);
  return share >= 0 && share <= 1 ? share : share > 1 ? 1 : share < 0 ? 0 : 0.5;
}

OpEffect SplitEdge::apply(Edit& edit) const {
  assert(check(edit.mesh()).legal());
  OpEffect effect;
  const Mesh& mesh = edit.mesh();
  put_point_into(edit, halfedge, blend(mesh), position(mesh), CutTriangles::yes, effect);
  return effect;
}

void warn_of_place(Halfedge h, double along, std::vector<Reason>& reasons) {
  if (along < 0 || along > 1) reasons.push_back({Rule::outside_edge, {edge(h)}});
}

void put_point_into(Edit& edit, Halfedge h, double along, CutTriangles cut, OpEffect& effect) {
  const Mesh& m = edit.mesh();
  put_point_into(edit, h, along, point_between(m.position(m.from(h)), m.position(m.to(h)), along), cut, effect);
}

void put_point_into(Edit& edit, Halfedge h, double along, const glm::dvec3& p, CutTriangles cut, OpEffect& effect) {
  const Mesh& m = edit.mesh();
  // With a new point on it the boundary loop of a closed cut has four halfedges and is no longer closed.
  Sheets cuts(edit);
  if (is_cut_on_points(m, h))
    for (Halfedge sheet : sheets_of(m, h))
      if (!m.is_outside(sheet) && !m.is_outside(twin(sheet))) effect.created.push_back(edge(cuts.open(sheet)));
  const std::vector<Halfedge> sheets = sheets_of(m, h);
  std::vector<Vertex> copies;
  for (Halfedge sheet : sheets) copies.push_back(cut_sheet(edit, sheet, along, p, cut, effect));
  if (copies.size() > 1) link_copies(edit, copies);
}

}  // namespace ryosen
