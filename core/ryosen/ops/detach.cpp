#include "ryosen/ops/detach.h"

#include <algorithm>
#include <cassert>
#include <unordered_set>

#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/faces_at.h"
#include "ryosen/ops/parameters/member_values.h"
#include "ryosen/ops/rules/pinch.h"
#include "ryosen/ops/rules/sheets.h"

namespace ryosen {

namespace {

using namespace parameters;

constexpr OpParameter detach_parameters[] = {
    with_words({"faces", "Faces", "面", "a face of the sheet, or all faces that are separated",
                "シートの一つの面、または切り離すすべての面"},
               list(face<&Detach::faces>("fN"), "fM"))};

}  // namespace

constinit const OpInfo Detach::info{.id = "detach",
                                    .name_en = "Detach",
                                    .name_ja = "シートの切り離し",
                                    .line = {.lists = {detach_parameters}},
                                    .help_en = "separates a sheet, or the named faces, from all other faces",
                                    .help_ja = "シート、または指定した面を独立した点に切り離す",
                                    .target = OpTargetKind::face,
                                    .group = OpGroup::join,
                                    .on_selection = OnSelection::all};

namespace {

using FaceSet = std::unordered_set<Face>;

// The points that faces of the set share with other faces, ascending.
std::vector<Vertex> shared_points(const Mesh& m, const FaceSet& faces) {
  std::vector<Vertex> points;
  for (Face f : faces)
    for (Vertex v : vertices_around(m, f)) points.push_back(point(m, v));
  sort_unique(points);
  std::erase_if(points, [&](Vertex p) { return !any_of_faces_at(m, p, [&](Face f) { return !faces.contains(f); }); });
  return points;
}

FaceSet sheet_of(const Mesh& m, Face f) {
  const std::vector<Face> faces = faces_of_sheet(m, f);
  return {faces.begin(), faces.end()};
}

FaceSet faces_meant(const Mesh& m, const std::vector<Face>& named) {
  if (named.size() > 1) return {named.begin(), named.end()};
  FaceSet sheet = sheet_of(m, named[0]);
  if (shared_points(m, sheet).empty()) return {named[0]};
  return sheet;
}

// Moves the fans of these faces at a point to vertices of a new point. Every fan must be entirely in the set or
// entirely outside. Returns a vertex of the new point.
Vertex split_point(Edit& edit, Sheets& sheets, Vertex p, const FaceSet& faces) {
  const Mesh& m = edit.mesh();
  std::vector<Vertex> copies, away, rest;
  for_each_copy(m, p, [&](Vertex copy) { copies.push_back(copy); });
  std::sort(copies.begin(), copies.end());
  for (Vertex copy : copies) {
    const std::vector<Fan> fans = fans_at(m, copy);
    const auto goes = [&](const Fan& fan) { return faces.contains(fan.lowest_face); };
    bool has_wire = false;
    for (Halfedge h : outgoing(m, copy)) has_wire = has_wire || m.is_wire(edge(h));
    if (!fans.empty() && !has_wire && std::all_of(fans.begin(), fans.end(), goes)) {
      away.push_back(copy);
      continue;
    }
    rest.push_back(copy);
    for (const Fan& fan : fans)
      if (goes(fan)) away.push_back(sheets.take_out(fan));
  }
  // The faces that are not detached keep the number.
  if (away[0] < rest[0]) {
    sheets.exchange(away[0], rest[0]);
    std::swap(away[0], rest[0]);
  }
  link_copies(edit, away);
  link_copies(edit, rest);
  for (Vertex v : away) sheets.changed_around(v);
  return away[0];
}

}  // namespace

Verdict Detach::check(const Mesh& mesh) const {
  Verdict verdict;
  if (any_is_gone(mesh, faces, verdict)) return verdict;
  if (shared_points(mesh, faces_meant(mesh, faces)).empty()) verdict.refuse(Rule::detached, {faces[0]});
  return verdict;
}

std::vector<Reason> Detach::warnings(const Mesh& mesh) const {
  const FaceSet away = faces_meant(mesh, faces);
  std::vector<Face> in_order(away.begin(), away.end());
  std::sort(in_order.begin(), in_order.end());
  std::vector<Reason> reasons;
  warn_of_pinch(pinched_without(mesh, in_order, true), reasons);
  return reasons;
}

OpEffect Detach::apply(Edit& edit) const {
  const Mesh& m = edit.mesh();
  assert(check(m).legal());
  Sheets sheets(edit);
  const FaceSet away = faces_meant(m, faces);
  std::vector<Vertex> points = shared_points(m, away);
  std::vector<Face> in_order(away.begin(), away.end());
  std::sort(in_order.begin(), in_order.end());
  for (Face f : in_order) {
    std::vector<Halfedge> sides;
    for (Halfedge h : halfedges_around(m, f)) sides.push_back(h);
    for (Halfedge h : sides)
      if (const Face beside = m.face(twin(h)); beside && !away.contains(beside)) sheets.open(h);
  }
  const std::size_t shared = points.size();
  for (std::size_t i = 0; i < shared; ++i) points.push_back(split_point(edit, sheets, points[i], away));
  sheets.make_manifold(points);
  return sheets.finish();
}

}  // namespace ryosen
