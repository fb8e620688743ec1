#include "ryosen/ops/rules/attach_face.h"

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/ops/rules/surgery.h"

namespace ryosen {

namespace {

// The boundary halfedge between two points that a new face can use, preferring one whose edge has a face to a wire.
// None if there is no edge.
Halfedge free_side(const Mesh& m, Vertex a, Vertex b) {
  Halfedge found;
  for (Halfedge h : sheets_between(m, a, b))
    if (m.is_outside(h) && (!found || m.is_outside(twin(found)))) found = h;
  return found;
}

bool has_room(const Mesh& m, Vertex v) { return m.is_isolated(v) || m.is_boundary(v); }

}  // namespace

Vertex roomy_copy(const Mesh& m, Vertex v) {
  if (has_room(m, v)) return v;
  Vertex found;
  for_each_copy(m, v, [&](Vertex copy) {
    if (has_room(m, copy) && (!found || copy < found)) found = copy;
  });
  return found;
}

Face attach_face(Edit& edit, Sheets& sheets, std::span<const Vertex> corners) {
  const Mesh& m = edit.mesh();
  const std::size_t n = corners.size();
  std::vector<Halfedge> sides(n);
  for (std::size_t i = 0; i < n; ++i) sides[i] = free_side(m, corners[i], corners[(i + 1) % n]);
  for (std::size_t i = 0; i < n; ++i) {
    if (sides[i]) continue;
    const Halfedge before = sides[(i + n - 1) % n], after = sides[(i + 1) % n];
    const Vertex a = before ? m.to(before) : roomy_copy(m, corners[i]);
    const Vertex b = after ? m.from(after) : roomy_copy(m, corners[(i + 1) % n]);
    const auto any_gap = [&](Vertex v) { return m.is_isolated(v) ? Halfedge() : m.prev(m.halfedge(v)); };
    sides[i] = link_edge(edit, a, before ? before : any_gap(a), b, after ? m.prev(after) : any_gap(b));
  }
  for (std::size_t i = 0; i < n; ++i) sheets.join_corner(sides[i], sides[(i + 1) % n]);
  const Face f = edit.add_face(sides[0]);
  set_face_along(edit, sides[0], f);
  std::vector<Vertex> met;
  for (Vertex v : vertices_around(m, f)) met.push_back(v);
  for (Vertex v : met) hold_outside(edit, v);
  sheets.changed(f);
  return f;
}

}  // namespace ryosen
