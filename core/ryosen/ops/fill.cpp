#include "ryosen/ops/fill.h"

#include <algorithm>
#include <cassert>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/ops/parameters/member_values.h"
#include "ryosen/ops/rules/face_lists.h"
#include "ryosen/ops/rules/pinch.h"
#include "ryosen/ops/rules/sheets.h"
#include "ryosen/ops/rules/surgery.h"

namespace ryosen {

namespace {

using namespace parameters;

constexpr OpParameter fill_parameters[] = {
    with_words({"edge", "Edge", "稜線", "an edge of the hole", "穴の稜線"}, required(edge<&Fill::halfedge>("A-B")))};

void turn_to_hole(const Mesh& mesh, void* op) {
  Fill& fill = *static_cast<Fill*>(op);
  fill = Fill::of_edge(mesh, fill.halfedge);
}

}  // namespace

constinit const OpInfo Fill::info{.id = "fill",
                                  .name_en = "Fill hole",
                                  .name_ja = "穴埋め",
                                  .line = {.lists = {fill_parameters}, .normalise = turn_to_hole},
                                  .help_en = "puts one face on the hole at a boundary edge",
                                  .help_ja = "境界稜線 A-B の穴に一枚の面を張る",
                                  .target = OpTargetKind::edge,
                                  .group = OpGroup::fill,
                                  .subject = Subject::cycle,
                                  .made = {"One face was made.", "# faces were made.", "面を # 個張りました。"}};

namespace {

// A point visited twice by the cycle, or none.
Vertex repeated_point(std::vector<std::uint32_t> points) {
  std::sort(points.begin(), points.end());
  const auto twice = std::adjacent_find(points.begin(), points.end());
  return twice == points.end() ? Vertex() : Vertex(*twice);
}

}  // namespace

Fill Fill::of_edge(const Mesh& mesh, Halfedge h) {
  return {!mesh.is_outside(h) && mesh.is_outside(twin(h)) ? twin(h) : h};
}

Fill Fill::at(const Mesh& mesh, const OpTarget& target) { return {outside_side(mesh, target.halfedge)}; }

Verdict Fill::check(const Mesh& mesh) const {
  Verdict verdict;
  if (is_gone(mesh, halfedge, verdict)) return verdict;
  if (!mesh.is_outside(halfedge)) return refused_by(Rule::has_face, {edge(halfedge), mesh.face(halfedge)});
  const std::vector<std::uint32_t> points = points_along(mesh, halfedge);
  if (const Vertex twice = repeated_point(points)) verdict.refuse(Rule::corner_twice, {twice, edge(halfedge)});
  if (points.size() < 3) verdict.refuse(Rule::loop, {edge(halfedge)});
  for (Halfedge h : loop(mesh, halfedge))
    if (point_edge(mesh, h).faces() >= 2)
      verdict.refuse(Rule::copies, {point(mesh, mesh.from(h)), point(mesh, mesh.to(h))});
  if (!verdict.legal()) return verdict;
  if (const Face other = face_on(mesh, point_set(points))) verdict.refuse(Rule::duplicate_face, {other});
  return verdict;
}

std::vector<Reason> Fill::warnings(const Mesh& mesh) const { return warnings_of_face_in(mesh, halfedge); }

OpEffect Fill::apply(Edit& edit) const {
  const Mesh& m = edit.mesh();
  assert(check(m).legal());
  Sheets sheets(edit);
  const Face f = edit.add_face(halfedge);
  edit.fresh(f);
  fill_loop(edit, halfedge, f);
  std::vector<Vertex> corners;
  for (Vertex v : vertices_around(m, f)) corners.push_back(v);
  for (Vertex v : corners) hold_outside(edit, v);
  sheets.changed(f);
  sheets.make_manifold(corners);
  return sheets.finish();
}

}  // namespace ryosen
