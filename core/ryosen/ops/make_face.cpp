#include "ryosen/ops/make_face.h"

#include <algorithm>
#include <cassert>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/ops/parameters/member_values.h"
#include "ryosen/ops/rules/face_geometry.h"
#include "ryosen/ops/rules/face_lists.h"
#include "ryosen/ops/rules/pinch.h"
#include "ryosen/ops/rules/sheets.h"
#include "ryosen/ops/rules/surgery.h"
#include "ryosen/ops/rules/united_values.h"

namespace ryosen {

namespace {

using namespace parameters;

constexpr OpParameter make_face_parameters[] = {
    with_words({"first", "First corner", "最初の角", "the vertex at which the face begins", "面の最初の頂点"},
               required(unprinted(copy<&MakeFace::corners>("A")))),
    with_words({"second", "Second corner", "二番目の角", "the vertex counter-clockwise from the first",
                "最初の頂点から反時計回りに次の頂点"},
               required(unprinted(copy<&MakeFace::corners>("B")))),
    with_words(
        {"others", "Other corners", "残りの角", "the other vertices, counter-clockwise", "残りの頂点（反時計回り）"},
        list(copy<&MakeFace::corners>("C")))};

}  // namespace

constinit const OpInfo MakeFace::info{.id = "make_face",
                                      .name_en = "Make face",
                                      .name_ja = "面生成",
                                      .line = {.lists = {make_face_parameters}},
                                      .help_en = "makes a face on three or more vertices, counter-clockwise",
                                      .help_ja = "三つ以上の頂点に反時計回りに面を張る",
                                      .target = OpTargetKind::selection,
                                      .group = OpGroup::fill,
                                      .on_selection = OnSelection::all};

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

// A copy of v with room for new edges, preferring v, or none.
Vertex roomy_copy(const Mesh& m, Vertex v) {
  if (has_room(m, v)) return v;
  Vertex found;
  for_each_copy(m, v, [&](Vertex copy) {
    if (has_room(m, copy) && (!found || copy < found)) found = copy;
  });
  return found;
}

// Refuses a side that a face already traverses in this direction, or that has two faces.
void check_side(const Mesh& m, Vertex a, Vertex b, Verdict& verdict) {
  const Halfedge any = any_sheet_between(m, a, b);
  if (any.is_none()) return;
  const PointEdge faces = point_edge(m, any);
  if (faces.forward == 0 && faces.backward <= 1) return;
  const auto refuse = [&](Halfedge h) {
    const Halfedge side = m.is_outside(h) ? twin(h) : h;
    if (m.is_outside(side)) return false;
    verdict.refuse(Rule::has_face, {edge(h), m.face(side)});
    return true;
  };
  if (has_copies(m, a) || has_copies(m, b)) {  // the first of perhaps many, in the order of sheets_between
    any_of_copies(m, a, [&](Vertex copy) {
      for (Halfedge h : outgoing(m, copy))
        if (same_point(m, m.to(h), b) && refuse(h)) return true;
      return false;
    });
    return;
  }
  for (Halfedge h : sheets_between(m, a, b))
    if (refuse(h)) return;
}

}  // namespace

Verdict MakeFace::check(const Mesh& m) const {
  Verdict verdict;
  for (Vertex v : corners)
    if (is_gone(m, v, verdict)) return verdict;
  std::vector<std::uint32_t> points;
  for (Vertex v : corners) points.push_back(point(m, v).index);
  const std::vector<std::uint32_t> set = point_set(points);
  for (std::uint32_t p : set)
    if (std::count(points.begin(), points.end(), p) > 1) verdict.refuse(Rule::corner_twice, {Vertex(p)});
  if (corners.size() < 3) verdict.refuse(Rule::loop, {});
  if (!verdict.legal()) return verdict;
  const std::size_t n = corners.size();
  std::vector<bool> is_new(n);
  for (std::size_t i = 0; i < n; ++i) {
    is_new[i] = !are_joined(m, corners[i], corners[(i + 1) % n]);
    check_side(m, corners[i], corners[(i + 1) % n], verdict);
  }
  for (std::size_t i = 0; i < n; ++i)
    if (is_new[i] && is_new[(i + n - 1) % n] && !roomy_copy(m, corners[i]))
      verdict.refuse(Rule::no_gap, {corners[i], m.face(m.halfedge(corners[i]))});
  if (const Face other = face_on(m, set)) verdict.refuse(Rule::duplicate_face, {other});
  return verdict;
}

std::vector<Reason> MakeFace::warnings(const Mesh& m) const {
  FaceGeometry after;
  for (Vertex v : corners) after.add(m.position(v));
  std::vector<Reason> reasons;
  if (after.is_degenerate()) reasons.push_back({Rule::degenerate, {corners.begin(), corners.end()}});
  std::vector<std::uint32_t> points;
  for (Vertex v : corners) points.push_back(point(m, v).index);
  warn_of_pinch(pinched_by_face(m, points), reasons);
  return reasons;
}

Face attach_face(Edit& edit, Sheets& sheets, std::span<const Vertex> corners) {
  const Mesh& m = edit.mesh();
  const std::size_t n = corners.size();
  std::vector<Halfedge> sides(n);
  std::vector<Edge> made;
  for (std::size_t i = 0; i < n; ++i) sides[i] = free_side(m, corners[i], corners[(i + 1) % n]);
  for (std::size_t i = 0; i < n; ++i) {
    if (sides[i]) continue;
    const Halfedge before = sides[(i + n - 1) % n], after = sides[(i + 1) % n];
    const Vertex a = before ? m.to(before) : roomy_copy(m, corners[i]);
    const Vertex b = after ? m.from(after) : roomy_copy(m, corners[(i + 1) % n]);
    const auto any_gap = [&](Vertex v) { return m.is_isolated(v) ? Halfedge() : m.prev(m.halfedge(v)); };
    sides[i] = link_edge(edit, a, before ? before : any_gap(a), b, after ? m.prev(after) : any_gap(b));
    made.push_back(edge(sides[i]));
  }
  for (std::size_t i = 0; i < n; ++i) sheets.join_corner(sides[i], sides[(i + 1) % n]);
  const Face f = edit.add_face(sides[0]);
  edit.fresh(f);
  fill_loop(edit, sides[0], f);
  std::vector<Vertex> met;
  for (Vertex v : vertices_around(m, f)) met.push_back(v);
  for (Vertex v : met) hold_outside(edit, v);
  share_values(edit, made);
  sheets.changed(f);
  return f;
}

OpEffect MakeFace::apply(Edit& edit) const {
  assert(check(edit.mesh()).legal());
  Sheets sheets(edit);
  const Face f = attach_face(edit, sheets, corners);
  std::vector<Vertex> met;
  for (Vertex v : vertices_around(edit.mesh(), f)) met.push_back(v);
  sheets.make_manifold(met);
  return sheets.finish();
}

}  // namespace ryosen
