// What a subdivision keeps sharp: creases and corners of one level, and the rules at them.
//
//    smooth: no sharp edge, or one that ends here (a dart)     sharpness s of an edge [DeRose98]: it is sharp for s
//    crease: two sharp edges, along which a curve runs         steps and smooth from then on; infinite on a
//    corner: three or more, or named; never moves              boundary. Where s falls below 1, both rules are blended.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <vector>

#include "ryosen/mesh/circulate.h"

namespace ryosen::subdivide {

inline constexpr float always_sharp = std::numeric_limits<float>::infinity();

// Of all edges and vertices of a mesh; an empty column stands for none.
struct Creases {
  std::vector<float> sharpness;       // per edge; boundaries and wires are sharp whatever it says
  std::vector<std::uint8_t> corners;  // per vertex

  bool is_corner(Vertex v) const { return !corners.empty() && corners[v.index] != 0; }
  float sharpness_of(const Mesh& mesh, Halfedge h) const {
    if (mesh.is_outside(h) || mesh.is_outside(twin(h))) return always_sharp;
    return sharpness.empty() ? 0 : sharpness[edge(h).index];
  }
};

enum class VertexRule { smooth, crease, corner };
struct RuleAt {
  VertexRule rule = VertexRule::smooth;
  std::array<Vertex, 2> along{};  // of a crease: the next vertices on it, both ways; of a dart one

  bool is_dart() const { return rule == VertexRule::smooth && along[0]; }
};

// The rule at a vertex when `steps` more steps have been taken from the sharpness. Cost: the valence, O(1) at a
// boundary where nothing else is sharp.
inline RuleAt rule_at(const Mesh& mesh, const Creases& creases, Vertex v, float steps = 0) {
  if (creases.is_corner(v)) return {VertexRule::corner};
  RuleAt at;
  if (creases.sharpness.empty()) {
    if (!mesh.is_boundary(v)) return at;
    // A vertex with one gap, whose stored halfedge runs along it; several gaps make it a corner beforehand.
    const Halfedge out = mesh.halfedge(v);
    return {VertexRule::crease, {mesh.to(out), mesh.from(mesh.prev(out))}};
  }
  std::uint32_t sharp = 0;
  for (const Halfedge h : outgoing(mesh, v)) {
    if (!(creases.sharpness_of(mesh, h) > steps)) continue;
    if (sharp < 2) at.along[sharp] = mesh.to(h);
    ++sharp;
  }
  at.rule = sharp < 2 ? VertexRule::smooth : sharp == 2 ? VertexRule::crease : VertexRule::corner;
  return at;
}
// How much the rule of now weighs where it differs from that of the next step: the mean sharpness of the edges that
// become smooth in this one.
inline double weight_of_rule(const Mesh& mesh, const Creases& creases, Vertex v) {
  double sum = 0, count = 0;
  for (const Halfedge h : outgoing(mesh, v)) {
    const double sharpness = creases.sharpness_of(mesh, h);
    if (sharpness <= 0 || sharpness > 1) continue;
    sum += sharpness;
    ++count;
  }
  return count > 0 ? sum / count : 1;
}

// Where a vertex comes to with this step: by the mask of smooth vertices, that of creases (1 6 1)/8, or nowhere.
template <class Smooth>
glm::dvec3 place_of_vertex(const Mesh& mesh, const Creases& creases, Vertex v, const Smooth& smooth) {
  const glm::dvec3& here = mesh.position(v);
  if (mesh.is_isolated(v)) return here;
  const auto by_rule = [&](const RuleAt& at) {
    if (at.rule == VertexRule::corner) return here;
    if (at.rule == VertexRule::smooth) return glm::dvec3(smooth(v));
    return 0.75 * here + (0.125 * mesh.position(at.along[0]) + 0.125 * mesh.position(at.along[1]));
  };
  const RuleAt now = rule_at(mesh, creases, v);
  if (now.rule == VertexRule::smooth || creases.sharpness.empty()) return by_rule(now);
  const RuleAt later = rule_at(mesh, creases, v, 1);
  if (later.rule == now.rule) return by_rule(now);
  const double weight = weight_of_rule(mesh, creases, v);
  return weight >= 1 ? by_rule(now) : weight * by_rule(now) + (1 - weight) * by_rule(later);
}

// Where the new vertex on an edge comes to: its middle where it is sharp.
template <class Smooth>
glm::dvec3 place_on_edge(const Mesh& mesh, const Creases& creases, Edge e, const Smooth& smooth) {
  const Halfedge h = halfedge(e);
  const double sharpness = creases.sharpness_of(mesh, h);
  if (sharpness <= 0) return smooth(h);
  const glm::dvec3 middle = 0.5 * mesh.position(mesh.from(h)) + 0.5 * mesh.position(mesh.to(h));
  return sharpness >= 1 ? middle : sharpness * middle + (1 - sharpness) * glm::dvec3(smooth(h));
}

// The place on the limit of a vertex: (1 4 1)/6 along a crease, which is the cubic spline through it.
template <class Smooth, class Dart>
glm::dvec3 limit_of_vertex(const Mesh& mesh, const Creases& creases, Vertex v, const Smooth& smooth, const Dart& dart) {
  const glm::dvec3& here = mesh.position(v);
  if (mesh.is_isolated(v)) return here;
  const RuleAt at = rule_at(mesh, creases, v);
  if (at.rule == VertexRule::corner) return here;
  if (at.rule == VertexRule::smooth) return at.is_dart() ? dart(v) : smooth(v);
  return here * (2.0 / 3) + (mesh.position(at.along[0]) / 6.0 + mesh.position(at.along[1]) / 6.0);
}

}  // namespace ryosen::subdivide
