#include "ryosen/ops/euler/separate_edge.h"

#include <cassert>

#include "ryosen/mesh/rings.h"
#include "ryosen/ops/lines/arguments.h"
#include "ryosen/ops/rules/point_in_edge.h"

namespace ryosen {

Parsed<SeparateEdge> SeparateEdge::parse(const Mesh& mesh, std::span<const std::string_view> arguments) {
  ArgumentReader in(mesh, arguments, info.syntax);
  SeparateEdge op{in.halfedge()};
  if (!in.at_end()) op.along = in.number();
  return in.result(op);
}

std::string SeparateEdge::command(const Mesh& mesh) const {
  return "separate_edge " + name_of(mesh, halfedge) + (along == 0.5 ? "" : " " + format_double(along));
}

Verdict SeparateEdge::check(const Mesh& mesh) const {
  Verdict verdict;
  if (is_gone(mesh, halfedge, verdict)) return verdict;
  if (is_bridge(mesh, halfedge)) verdict.refuse(Rule::loop, {edge(halfedge), mesh.face(halfedge)});
  return verdict;
}

std::vector<Reason> SeparateEdge::warnings(const Mesh&) const {
  std::vector<Reason> reasons;
  warn_of_place(halfedge, along, reasons);
  return reasons;
}

OpEffect SeparateEdge::apply(Edit& edit) const {
  assert(check(edit.mesh()).legal());
  OpEffect effect;
  put_point_into(edit, halfedge, along, CutTriangles::no, effect);
  return effect;
}

}  // namespace ryosen
