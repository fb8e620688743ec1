#include "ryosen/ops/split_edge.h"

#include <algorithm>
#include <cassert>
#include <glm/geometric.hpp>

#include "ryosen/geometry/is_finite.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/rings.h"
#include "ryosen/ops/parameters/member_values.h"
#include "ryosen/ops/rules/face_geometry.h"
#include "ryosen/ops/rules/face_lists.h"
#include "ryosen/ops/rules/point_in_edge.h"

namespace ryosen {

namespace {

using namespace parameters;

std::optional<Text> fault_of_split(const Mesh& mesh, const void* op) {
  const auto& [h, along, place] = *static_cast<const SplitEdge*>(op);
  if (place && !is_finite(*place)) return Text{"X,Y,Z with finite coordinates", "有限の座標 X,Y,Z を"};
  const glm::dvec3 &a = mesh.position(mesh.from(h)), &b = mesh.position(mesh.to(h));
  if (place || !is_finite(a) || !is_finite(b) || is_finite(point_between(a, b, along))) return std::nullopt;
  return Text{"a t that leaves the new vertex at a finite place", "新しい頂点の座標が有限になる t を"};
}

constexpr OpDrag drag_of_split{
    .moved = [](const Mesh& mesh, const void* op, const ColumnLengths& before) -> std::vector<Element> {
      const Halfedge h = static_cast<const SplitEdge*>(op)->halfedge;
      return {mesh.to(h).index >= before.vertices ? mesh.to(h) : mesh.from(h)};
    },
    .from = [](const Mesh& mesh, const void* op) { return static_cast<const SplitEdge*>(op)->position(mesh); }};

constexpr OpParameter split_parameters[] = {
    with_words(
        {"edge", "Edge", "稜線", "the edge that is split", "分割する稜線"},
        missing(required(edge<&SplitEdge::halfedge>("A-B")), "an edge A-B is missing", "稜線 A-B の指定がありません")),
    with_words({"at", "Place", "位置",
                "where the new vertex lies, from 0 at A to 1 at B or at a position (in the middle if it is left out)",
                "新しい頂点の位置。A が 0、B が 1 の割合、または座標（省くと中央）"},
               dragged(drag_of_split,
                       expecting(optional(named("Fraction along the edge", "割合", number<&SplitEdge::along>("t")),
                                          named("Position", "座標", position<&SplitEdge::place>())),
                                 "a number t or X,Y,Z", "数 t または X,Y,Z を")))};

}  // namespace

constinit const OpInfo SplitEdge::info{.id = "split",
                                       .name_en = "Split edge",
                                       .name_ja = "辺細分",
                                       .line = {.lists = {split_parameters}, .fault = fault_of_split},
                                       .help_en = "puts a vertex at A + t (B - A), 0.5 without t, or at a place",
                                       .help_ja = "A + t(B − A)（t を省くと 0.5）、または指定の座標に頂点を置く",
                                       .key = 'D',
                                       .target = OpTargetKind::edge,
                                       .group = OpGroup::refine,
                                       .topology = Topology::kept,
                                       .subject = Subject::points};

Verdict SplitEdge::check(const Mesh& m) const {
  Verdict verdict;
  if (is_gone(m, halfedge, verdict)) return verdict;
  if (is_bridge(m, halfedge)) return refused_by(Rule::loop, {edge(halfedge), m.face(halfedge)});
  std::vector<std::pair<Vertex, Face>> apexes;
  for (Halfedge sheet : sheets_of_edge(m, halfedge))
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
  for (Halfedge sheet : sheets_of_edge(m, halfedge)) {
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

}  // namespace ryosen
