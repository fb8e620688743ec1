#include "ryosen/algo/duplicate/part.h"

#include <algorithm>
#include <map>

#include "ryosen/base/index_set.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/mesh/append_mesh.h"
#include "ryosen/mesh/attribute.h"
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

void keep_rows(AttributeColumn& column, const std::vector<bool>& stays) {
  std::vector<std::uint32_t> rows;
  for (std::uint32_t i = 0; i < stays.size(); ++i)
    if (stays[i]) rows.push_back(i);
  column = with_rows(column, rows);
}

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
  for (AttributeColumn& column : list.attributes)
    if (column.element == ElementKind::corner) keep_rows(column, corner_stays);
  keep_rows(list.texcoords.index, corner_stays);
  keep_rows(list.normals.index, corner_stays);
  keep_rows(list.corners, corner_stays);
  for (std::uint32_t& corner : list.corners) corner = number[corner];
  list.face_offsets = std::move(offsets);
  list.bridged = std::move(bridged);
}

// The listed edges of faces that are left, and of wires.
void keep_edges(IndexedMesh& list, const std::vector<std::uint32_t>& number,
                const std::vector<std::pair<std::uint32_t, std::uint32_t>>& wires) {
  if (list.edges.empty()) return;
  const std::vector<std::pair<std::uint32_t, std::uint32_t>> left = edges_of_faces(list);
  std::vector<bool> stays;
  for (ListedEdge& e : list.edges) {
    e = {number[e.from], number[e.to], e.row};
    const std::pair<std::uint32_t, std::uint32_t> ends = std::minmax({e.from, e.to});
    stays.push_back(std::binary_search(left.begin(), left.end(), ends) ||
                    std::binary_search(wires.begin(), wires.end(), ends));
  }
  keep_rows(list.edges, stays);
  for (AttributeColumn& column : list.attributes)
    if (column.element == ElementKind::edge) keep_rows(column, stays);
}

void keep(IndexedMesh& list, const std::vector<bool>& points, const std::vector<bool>& faces,
          const std::vector<std::uint32_t>& number, const std::vector<std::pair<std::uint32_t, std::uint32_t>>& wires) {
  keep_corners(list, faces, number);
  keep_rows(list.positions, points);
  keep_rows(list.vertex_colours, points);
  keep_rows(list.vertex_weights, points);
  for (FaceNames* names : {&list.materials, &list.groups, &list.objects, &list.smoothing})
    keep_rows(names->index, faces);
  keep_rows(list.face_colours.values, faces);
  keep_rows(list.face_colours.count, faces);
  for (AttributeColumn& column : list.attributes) {
    if (column.element == ElementKind::vertex) keep_rows(column, points);
    if (column.element == ElementKind::face) keep_rows(column, faces);
  }
  keep_edges(list, number, wires);
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
  std::map<std::pair<std::uint32_t, std::uint32_t>, Edge> edge_between;
  for (const Edge e : wires) {
    const auto [a, b] = ends(mesh, e);
    edge_between.try_emplace(
        std::minmax({number[compact.vertex_number[a.index]], number[compact.vertex_number[b.index]]}), e);
  }
  for (const auto& [ends, e] : edge_between) {
    part.wires.push_back(ends);
    part.wire_edges.push_back(e);
  }
  part.list = std::move(compact.mesh);
  keep(part.list, points, faces, number, part.wires);
  return part;
}

AddedPart add_part(Edit& edit, Part part, bool keeps_attributes) {
  const Mesh& mesh = edit.mesh();
  AddedPart added{Vertex(mesh.vertex_slots()), {}, 0};
  const Mesh surface = from_indexed(std::move(part.list));
  append_mesh(edit, surface, keeps_attributes ? AppendedAttributes::same_pools : AppendedAttributes::values);
  added.counts = surface.live();
  for (std::size_t i = 0; i < part.wires.size(); ++i) {
    const auto [a, b] = part.wires[i];
    const Vertex from(added.first.index + a), to(added.first.index + b);
    const MakeEdge wire{from, to, gap_at(mesh, from), gap_at(mesh, to)};
    if (!wire.check(mesh).legal()) {
      ++added.left_wires;
      continue;
    }
    wire.apply(edit);
    if (keeps_attributes) edit.derive(edge(any_sheet_between(mesh, from, to)), part.wire_edges[i], Derivation::copies);
    ++added.counts.edges;
  }
  return added;
}

}  // namespace ryosen
