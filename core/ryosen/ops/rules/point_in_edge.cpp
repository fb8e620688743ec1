#include "ryosen/ops/rules/point_in_edge.h"

#include <algorithm>

#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/rings.h"
#include "ryosen/ops/rules/face_geometry.h"
#include "ryosen/ops/rules/face_lists.h"
#include "ryosen/ops/rules/shares.h"
#include "ryosen/ops/rules/sheets.h"

namespace ryosen {

std::vector<Halfedge> sheets_of_edge(const Mesh& m, Halfedge h) {
  if (!is_cut_on_points(m, h)) return {h};
  std::vector<Halfedge> sheets = sheets_between(m, m.from(h), m.to(h));
  const auto lowest = [&](Halfedge s) { return std::min(m.face(s), m.face(twin(s))); };
  std::sort(sheets.begin(), sheets.end(), [&](Halfedge x, Halfedge y) { return lowest(x) < lowest(y); });
  return sheets;
}

namespace {

// Cuts a triangle from the new vertex m to the third corner: `into` ends at m and `out` starts there. The part with A,
// the origin of the edge, keeps the face.
//
//            third                      part of A: a -> m -> third
//           /  |  \                     other:     m -> b -> third
//          a---m---b
Face cut_triangle(Edit& edit, Halfedge into, Halfedge out, bool origin_keeps, double along, OpEffect& effect) {
  const Mesh& mesh = edit.mesh();
  const Face old = mesh.face(into);
  const Halfedge after_out = mesh.next(out), before_into = mesh.prev(into);
  const Vertex m = mesh.from(out), third = mesh.from(before_into);
  const Halfedge down = edit.add_edge(m, third), up = twin(down);  // down closes the part before m, up the other
  edit.fresh(edge(down));
  edit.connect(into, down);
  edit.connect(down, before_into);
  edit.connect(after_out, up);
  edit.connect(up, out);
  const Face fresh = edit.add_face(origin_keeps ? out : into);
  const Face parts[] = {old, fresh};
  edit.divide<Face>(old, parts, [&] { return lengths_of_parts(along); });
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
  edit.derive(down, out, Derivation::copies);
  edit.derive(up, before_into, Derivation::copies);
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
  edit.derive(m, a, b, along, Derivation::copies);
  const Halfedge fresh = edit.add_edge(m, b), fresh_twin = twin(fresh);
  const Edge parts[] = {edge(h), edge(fresh)};
  edit.divide<Edge>(edge(h), parts, [&] { return lengths_of_parts(along); });
  effect.created.push_back(m);
  effect.created.push_back(edge(fresh));

  if (!mesh.is_outside(h)) edit.derive(fresh, h, h_next, along, Derivation::copies);
  if (!mesh.is_outside(o)) {
    edit.derive(fresh_twin, o, Derivation::copies);
    edit.derive(o, mesh.next(o), o, along, Derivation::copies);
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
  if (cut_left) effect.changed.push_back(cut_triangle(edit, h, fresh, true, along, effect));
  if (cut_right) effect.changed.push_back(cut_triangle(edit, fresh_twin, o, false, along, effect));
  return m;
}

}  // namespace

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
    for (Halfedge sheet : sheets_of_edge(m, h))
      if (!m.is_outside(sheet) && !m.is_outside(twin(sheet))) effect.created.push_back(edge(cuts.open(sheet)));
  const std::vector<Halfedge> sheets = sheets_of_edge(m, h);
  std::vector<Vertex> copies;
  for (Halfedge sheet : sheets) copies.push_back(cut_sheet(edit, sheet, along, p, cut, effect));
  if (copies.size() > 1) link_copies(edit, copies);
}

}  // namespace ryosen
