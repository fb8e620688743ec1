#include "ryosen/ops/split_edge.h"

#include <algorithm>
#include <cassert>
#include <glm/geometric.hpp>

#include "ryosen/geometry/is_finite.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/rings.h"
#include "ryosen/ops/lines/arguments.h"
#include "ryosen/ops/rules/face_geometry.h"
#include "ryosen/ops/rules/point_in_edge.h"

namespace ryosen {

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
