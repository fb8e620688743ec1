#include "ryosen/ops/euler/make_loop.h"

#include <cassert>

#include "ryosen/mesh/copies.h"
#include "ryosen/ops/parameters/member_values.h"
#include "ryosen/ops/rules/face_lists.h"
#include "ryosen/ops/rules/pinch.h"
#include "ryosen/ops/rules/surgery.h"

namespace ryosen {

namespace {

using namespace parameters;

constexpr OpParameter make_loop_parameters[] = {with_words(
    {"edge", "Edge", "稜線", "a halfedge of the cycle, with the outside on its left", "閉路の半稜線。左側が外側"},
    required(edge<&MakeLoop::halfedge>("A-B")))};

}  // namespace

constinit const OpInfo MakeLoop::info{.id = "make_loop",
                                      .name_en = "Make loop",
                                      .name_ja = "ループ生成",
                                      .line = {.lists = {make_loop_parameters}},
                                      .help_en = "puts a face into the outside cycle left of A-B",
                                      .help_ja = "半稜線 A-B の左の外側の閉路に面を張る",
                                      .target = OpTargetKind::edge,
                                      .group = OpGroup::euler,
                                      .aliases = "mf",
                                      .subject = Subject::cycle};

MakeLoop MakeLoop::at(const Mesh& mesh, const OpTarget& target) { return {outside_side(mesh, target.halfedge)}; }

namespace {

// Whether reading the resulting polygon list would give the same sheets at h: exactly two faces in opposite directions
// share one edge, of three or more each has its own.
bool keeps_sheets(const Mesh& m, Halfedge h) {
  const PointEdge at = point_edge(m, h);
  if (!m.is_outside(twin(h))) return at.faces() == 1;
  return at.faces() != 1 || at.backward == 0;
}

}  // namespace

Verdict MakeLoop::check(const Mesh& mesh) const {
  Verdict verdict;
  if (is_gone(mesh, halfedge, verdict)) return verdict;
  if (!mesh.is_outside(halfedge)) return refused_by(Rule::has_face, {edge(halfedge), mesh.face(halfedge)});
  CornerLoops cycle;
  cycle.add(points_along(mesh, halfedge));
  if (!take_out_bridges(cycle)) return refused_by(Rule::loop, {edge(halfedge)});
  for (Halfedge h : loop(mesh, halfedge))
    if (!keeps_sheets(mesh, h)) verdict.refuse(Rule::copies, {point(mesh, mesh.from(h)), point(mesh, mesh.to(h))});
  if (!verdict.legal()) return verdict;
  if (const Face other = face_on(mesh, point_set(cycle.corners))) verdict.refuse(Rule::duplicate_face, {other});
  return verdict;
}

std::vector<Reason> MakeLoop::warnings(const Mesh& mesh) const { return warnings_of_face_in(mesh, halfedge); }

OpEffect MakeLoop::apply(Edit& edit) const {
  assert(check(edit.mesh()).legal());
  const Face f = edit.add_face(halfedge);
  edit.fresh(f);
  fill_loop(edit, halfedge, f);
  for (Halfedge h : loop(edit.mesh(), halfedge)) hold_outside(edit, edit.mesh().from(h));
  return {.created = {f}, .changed = {f}};
}

}  // namespace ryosen
