#include "ryosen/algo/transform/moved_points.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <limits>

#include "ryosen/base/index_set.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/geometry/trees/bvh.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"

namespace ryosen {

namespace {

// Smooth at both ends.
double share_at(double distance, double radius) {
  const double x = distance / radius, rest = 1 - x * x;
  return rest * rest;
}

}  // namespace

std::vector<Vertex> points_of(const Mesh& mesh, std::span<const Element> elements) {
  IndexSet points;
  const auto add = [&](Vertex v) { points.insert(point(mesh, v).index); };
  for (const Element& e : elements) switch (e.kind) {
      case Element::Kind::vertex:
        add(e.vertex());
        break;
      case Element::Kind::halfedge:
        add(mesh.from(e.halfedge()));
        add(mesh.to(e.halfedge()));
        break;
      case Element::Kind::edge:
        add(ends(mesh, e.edge()).first);
        add(ends(mesh, e.edge()).second);
        break;
      case Element::Kind::face:
        for (const Vertex v : vertices_around(mesh, e.face())) add(v);
    }
  std::vector<Vertex> found;
  points.for_each([&](std::uint32_t i) { found.emplace_back(i); });
  return found;
}

std::vector<MovedPoint> moved_points(const Mesh& mesh, std::span<const Vertex> whole, double falloff_radius) {
  std::vector<MovedPoint> moved;
  if (!(falloff_radius > 0)) {
    for (const Vertex v : whole) moved.push_back({v});
    return moved;
  }
  std::vector<Primitive> centres;
  for (const Vertex v : whole) centres.push_back(Primitive::point(v.index));
  Bvh tree;
  tree.build(mesh.positions(), std::move(centres));
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
    const Vertex v(i);
    if (!mesh.is_alive(v) || point(mesh, v) != v || !is_finite(mesh.position(v))) continue;
    const auto nearest = tree.nearest(mesh.positions(), mesh.position(v), falloff_radius);
    if (nearest && nearest->distance < falloff_radius)
      moved.push_back({v, share_at(nearest->distance, falloff_radius)});
  }
  return moved;
}

glm::dvec3 middle_of(const Mesh& mesh, std::span<const Vertex> points) {
  glm::dvec3 sum(0);
  double count = 0;
  for (const Vertex v : points)
    if (is_finite(mesh.position(v))) {
      sum += mesh.position(v);
      ++count;
    }
  return count > 0 ? sum / count : sum;
}

}  // namespace ryosen
