#include "ryosen/algo/duplicate/part.h"

#include <algorithm>

#include "ryosen/base/index_set.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/mesh/append_mesh.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/ops/euler/make_edge.h"

namespace ryosen {

namespace {

// Which elements of a mesh are meant.
class Meant {
 public:
  Meant(const Mesh& mesh, std::span<const Element> elements) : mesh_(mesh) {
    for (const Element& e : elements) switch (e.kind) {
        case Element::Kind::vertex:
          vertices_.insert(point(mesh, e.vertex()).index);
          break;
        case Element::Kind::halfedge:
          edges_.insert(edge(e.halfedge()).index);
          break;
        case Element::Kind::edge:
          edges_.insert(e.index);
          break;
        case Element::Kind::face:
          faces_.insert(e.index);
      }
  }
  bool has_vertex(Vertex v) const { return vertices_.contains(point(mesh_, v).index); }
  bool has_edge(Edge e) const { return edges_.contains(e.index); }
  bool has_face(Face f) const {
    if (faces_.contains(f.index)) return true;
    if (vertices_.empty() && edges_.empty()) return false;
    bool all_corners = true, all_sides = true;
    for (const Halfedge h : halfedges_around(mesh_, f)) {
      all_corners = all_corners && has_vertex(mesh_.from(h));
      all_sides = all_sides && has_edge(edge(h));
    }
    return all_corners || all_sides;
  }

 private:
  const Mesh& mesh_;
  IndexSet vertices_, edges_, faces_;
};

// Leaves those entries of a table with a row per element whose element stays.
template <class Values>
void keep_rows(Values& values, const std::vector<bool>& stays) {
  if (values.empty()) return;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (i < stays.size() && stays[i]) values[kept++] = values[i];
  values.resize(kept);
}

void keep_corners(IndexedMesh& list, const std::vector<bool>& stays, const std::vector<std::uint32_t>& number) {
  std::vector<bool> corner_stays(list.corners.size(), false);
  std::vector<std::uint32_t> offsets{0}, bridged;
  std::uint32_t faces = 0;
  for (std::size_t f = 0; f < list.face_count(); ++f) {
    if (!stays[f]) continue;
    const std::uint32_t begin = list.face_offsets[f], end = list.face_offsets[f + 1];
    std::fill(corner_stays.begin() + begin, corner_stays.begin() + end, true);
    offsets.push_back(offsets.back() + end - begin);
    if (std::binary_search(list.bridged.begin(), list.bridged.end(), f)) bridged.push_back(faces);
    ++faces;
  }
  keep_rows(list.texcoords.index, corner_stays);
  keep_rows(list.normals.index, corner_stays);
  keep_rows(list.corners, corner_stays);
  for (std::uint32_t& corner : list.corners) corner = number[corner];
  list.face_offsets = std::move(offsets);
  list.bridged = std::move(bridged);
}

void keep(IndexedMesh& list, const std::vector<bool>& points, const std::vector<bool>& faces) {
  std::vector<std::uint32_t> number(points.size(), no_index);
  std::uint32_t next = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points[i]) number[i] = next++;
  keep_corners(list, faces, number);
  keep_rows(list.positions, points);
  keep_rows(list.vertex_colours, points);
  keep_rows(list.vertex_weights, points);
  for (FaceNames* names : {&list.materials, &list.groups, &list.objects, &list.smoothing})
    keep_rows(names->index, faces);
  keep_rows(list.face_colours.values, faces);
  keep_rows(list.face_colours.count, faces);
  list.quarantine.clear();
  list.face_lines.clear();
  list.vertex_lines = {};
}

// Into the vertex along the outside; none at an isolated one.
Halfedge gap_at(const Mesh& mesh, Vertex v) {
  if (mesh.is_isolated(v)) return {};
  for (const Halfedge h : outgoing(mesh, v))
    if (mesh.is_outside(h)) return mesh.prev(h);
  return {};
}

}  // namespace

std::vector<Element> all_elements(const Mesh& mesh) {
  std::vector<Element> all;
  for (const Vertex v : live_vertices(mesh)) all.push_back(v);
  for (const Edge e : live_edges(mesh)) all.push_back(e);
  for (const Face f : live_faces(mesh)) all.push_back(f);
  return all;
}

Part part_of(const Mesh& mesh, std::span<const Element> elements, const FileTables& tables) {
  FileTables without = tables;
  without.quarantine.clear();
  CompactMesh compact = to_indexed(mesh, without);
  const Meant meant(mesh, elements);
  std::vector<bool> faces(compact.mesh.face_count(), false), points(compact.mesh.positions.size(), false);
  std::vector<Vertex> point_of(points.size());
  for (const Vertex v : live_vertices(mesh)) {
    if (point(mesh, v) != v) continue;
    point_of[compact.vertex_number[v.index]] = v;
    if (meant.has_vertex(v)) points[compact.vertex_number[v.index]] = true;
  }
  const auto take_point = [&](Vertex v) { points[compact.vertex_number[v.index]] = true; };
  for (const Face f : live_faces(mesh)) {
    if (!meant.has_face(f)) continue;
    faces[compact.face_number[f.index]] = true;
    for (const Vertex v : vertices_around(mesh, f)) take_point(v);
  }
  Part part;
  std::vector<Edge> wires;
  const auto is_in = [&](Halfedge h) { return mesh.face(h) && faces[compact.face_number[mesh.face(h).index]]; };
  for (const Edge e : live_edges(mesh)) {
    if (!meant.has_edge(e) || is_in(halfedge(e, 0)) || is_in(halfedge(e, 1))) continue;
    wires.push_back(e);
    take_point(ends(mesh, e).first);
    take_point(ends(mesh, e).second);
  }
  std::vector<std::uint32_t> number(points.size(), no_index);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points[i]) continue;
    number[i] = static_cast<std::uint32_t>(part.points.size());
    part.points.push_back(point_of[i]);
  }
  for (const Edge e : wires) {
    const auto [a, b] = ends(mesh, e);
    part.wires.push_back(std::minmax(number[compact.vertex_number[a.index]], number[compact.vertex_number[b.index]]));
  }
  sort_unique(part.wires);
  part.list = std::move(compact.mesh);
  keep(part.list, points, faces);
  return part;
}

AddedPart add_part(Edit& edit, Part part, bool keeps_attributes) {
  const Mesh& mesh = edit.mesh();
  AddedPart added{Vertex(mesh.vertex_slots()), {}, 0};
  const Mesh surface = from_indexed(std::move(part.list));
  append_mesh(edit, surface, keeps_attributes ? AppendedAttributes::same_pools : AppendedAttributes::none);
  added.counts = surface.live();
  for (const auto& [a, b] : part.wires) {
    const Vertex from(added.first.index + a), to(added.first.index + b);
    const MakeEdge wire{from, to, gap_at(mesh, from), gap_at(mesh, to)};
    if (!wire.check(mesh).legal()) {
      ++added.left_wires;
      continue;
    }
    wire.apply(edit);
    ++added.counts.edges;
  }
  return added;
}

}  // namespace ryosen
