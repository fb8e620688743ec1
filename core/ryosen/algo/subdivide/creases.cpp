#include "ryosen/algo/subdivide/creases.h"

namespace ryosen::subdivide {

namespace {

// A vertex with one gap, whose stored halfedge runs along it; several gaps make it a corner beforehand.
RuleAt rule_at_boundary(const Mesh& mesh, Vertex v) {
  const Halfedge out = mesh.halfedge(v);
  return {VertexRule::crease, {mesh.to(out), mesh.from(mesh.prev(out))}};
}

}  // namespace

RuleAt rule_at(const Mesh& mesh, const Creases& creases, Vertex v, float steps) {
  if (creases.is_corner(v)) return {VertexRule::corner};
  if (creases.sharpness.empty()) return mesh.is_boundary(v) ? rule_at_boundary(mesh, v) : RuleAt{};
  RuleAt at;
  std::uint32_t sharp = 0;
  for (const Halfedge h : outgoing(mesh, v)) {
    if (!(creases.sharpness_of(mesh, h) > steps)) continue;
    if (sharp < 2) at.along[sharp] = mesh.to(h);
    ++sharp;
  }
  at.rule = sharp < 2 ? VertexRule::smooth : sharp == 2 ? VertexRule::crease : VertexRule::corner;
  return at;
}

double weight_of_rule(const Mesh& mesh, const Creases& creases, Vertex v) {
  double sum = 0, count = 0;
  for (const Halfedge h : outgoing(mesh, v)) {
    const double sharpness = creases.sharpness_of(mesh, h);
    if (sharpness <= 0 || sharpness > 1) continue;
    sum += sharpness;
    ++count;
  }
  return count > 0 ? sum / count : 1;
}

}  // namespace ryosen::subdivide
