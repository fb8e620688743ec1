#include "ryosen/ops/make_face.h"

#include <algorithm>
#include <cassert>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/ops/parameters/member_values.h"
#include "ryosen/ops/rules/attach_face.h"
#include "ryosen/ops/rules/face_geometry.h"
#include "ryosen/ops/rules/face_lists.h"
#include "ryosen/ops/rules/pinch.h"
#include "ryosen/ops/rules/sheets.h"

namespace ryosen {

namespace {

using namespace parameters;

constexpr OpParameter make_face_parameters[] = {required(unprinted(copy<&MakeFace::corners>("A"))),
                                                required(unprinted(copy<&MakeFace::corners>("B"))),
                                                list(copy<&MakeFace::corners>("C"))};

}  // namespace

constinit const OpInfo MakeFace::info{.id = "make_face",
                                      .name_en = "Make face",
                                      .name_ja = "面生成",
                                      .line = {.lists = {make_face_parameters}},
                                      .help_en = "makes a face on three or more vertices, counter-clockwise",
                                      .help_ja = "三つ以上の頂点に反時計回りに面を張る",
                                      .key = '\0',
                                      .target = OpTargetKind::selection,
                                      .group = OpGroup::fill,
                                      .on_selection = OnSelection::all};

namespace {

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
