#include "tests/support/core/kernel_lists.h"

#include "ryosen/indexed/from_indexed.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/rings.h"
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

oracle::Complex complex_of(const Mesh& mesh, std::map<Halfedge, oracle::Place>* places) {
  oracle::Complex complex;
  for (std::uint32_t v = 0; v < mesh.vertex_slots(); ++v) {
    const bool alive = mesh.is_alive(Vertex(v));
    complex.live.push_back(alive);
    complex.point_of.push_back(static_cast<int>(alive ? point(mesh, Vertex(v)).index : v));
  }
  for (std::uint32_t f = 0; f < mesh.face_slots(); ++f) {
    complex.faces.emplace_back();
    if (!mesh.is_alive(Face(f))) continue;
    for_each_loop(mesh, Face(f), [&](Halfedge start) {
      oracle::Corners corners;
      for (Halfedge h : loop(mesh, start)) {
        if (places)
          (*places)[h] = {static_cast<int>(f), static_cast<int>(complex.faces.back().size()),
                          static_cast<int>(corners.size())};
        corners.push_back(static_cast<int>(mesh.from(h).index));
      }
      complex.faces.back().push_back(corners);
    });
  }
  for (std::uint32_t e = 0; e < mesh.edge_slots(); ++e) {
    if (!mesh.is_alive(Edge(e)) || !mesh.is_wire(Edge(e))) continue;
    const auto [a, b] = ends(mesh, Edge(e));
    complex.wires.push_back(std::minmax(static_cast<int>(a.index), static_cast<int>(b.index)));
  }
  return complex;
}

}  // namespace ryosen::test
