#include "tests/support/core/kernel_lists.h"

#include "core/build/from_indexed.h"
#include "core/mesh/circulate.h"
#include "core/mesh/copies.h"
#include "tests/support/core/random_meshes.h"

namespace ryosen::test {

using oracle::Kind;
using oracle::PolygonList;

Mesh kernel_mesh(const PolygonList& points, std::uint64_t seed) {
  Dice dice(seed);
  IndexedMesh indexed;
  for (int p = 0; p < points.size(); ++p) indexed.positions.emplace_back(dice.unit(), dice.unit(), dice.unit());
  for (const oracle::Corners& face : points.faces) {
    for (int p : face) indexed.corners.push_back(static_cast<std::uint32_t>(p));
    indexed.face_offsets.push_back(static_cast<std::uint32_t>(indexed.corners.size()));
  }
  return from_indexed(std::move(indexed));
}

PolygonList list_of(const Mesh& mesh, bool on_points) {
  PolygonList list;
  const auto number = [&](Vertex v) { return static_cast<int>((on_points ? point(mesh, v) : v).index); };
  list.live.assign(mesh.vertex_slots(), 0);
  for (std::uint32_t v = 0; v < mesh.vertex_slots(); ++v)
    if (mesh.is_alive(Vertex(v))) list.live[static_cast<std::size_t>(number(Vertex(v)))] = 1;
  for (std::uint32_t f = 0; f < mesh.face_slots(); ++f) {
    list.faces.emplace_back();
    if (!mesh.is_alive(Face(f))) continue;
    for (Vertex v : vertices_around(mesh, Face(f))) list.faces.back().push_back(number(v));
  }
  return list;
}

Halfedge halfedge_of(const Mesh& mesh, const oracle::Operation& operation) {
  for (Halfedge h : halfedges_around(mesh, Face(static_cast<std::uint32_t>(operation.face)))) {
    const int a = static_cast<int>(point(mesh, mesh.from(h)).index),
              b = static_cast<int>(point(mesh, mesh.to(h)).index);
    if (a == operation.from && b == operation.to) return h;
    if (b == operation.from && a == operation.to) return twin(h);
  }
  return Halfedge();
}

AnyOp op_of(const Mesh& mesh, const oracle::Operation& operation) {
  const Halfedge h = halfedge_of(mesh, operation);
  if (operation.kind == Kind::collapse) return CollapseEdge{h};
  if (operation.kind == Kind::split) return SplitEdge{h};
  return SwapEdge{h, operation.kind == Kind::swap_back};
}

}  // namespace ryosen::test
