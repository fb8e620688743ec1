#include "ryosen/textbook/forms/polygons.h"

#include <iterator>
#include <utility>

#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/live_elements.h"

namespace ryosen::forms {

std::vector<Halfedge> inner_loops(const Mesh& mesh, Face f) {
  std::vector<Halfedge> starts;
  for (std::uint32_t r = mesh.first_ring(f); r != no_index; r = mesh.ring(r).next)
    starts.push_back(mesh.ring(r).halfedge);
  return starts;
}

void set_inner_loops(MeshColumns& c, Face f, std::span<const Halfedge> starts) {
  if (starts.empty()) return;
  c.first_ring.resize(c.face_halfedge.size(), no_index);
  for (std::size_t i = starts.size(); i-- > 0;) {
    c.rings.push_back({starts[i], c.first_ring[f.index]});
    c.first_ring[f.index] = static_cast<std::uint32_t>(c.rings.size()) - 1;
    ++c.live.rings;
  }
}

std::size_t corners_of_loop(const Mesh& mesh, Halfedge start) {
  const auto corners = loop(mesh, start);
  return static_cast<std::size_t>(std::distance(corners.begin(), corners.end()));
}

bool is_further_copy(const Mesh& mesh, Vertex v) { return mesh.copy_point(v) != v; }

Numbering::Numbering(const Mesh& mesh)
    : vertex(mesh.vertex_slots(), no_index),
      point(mesh.vertex_slots(), no_index),
      edge(mesh.edge_slots(), no_index),
      face(mesh.face_slots(), no_index) {
  for (const Vertex v : live_vertices(mesh)) {
    vertex[v.index] = vertices++;
    if (point[v.index] != no_index) continue;
    point[v.index] = points;
    for (Vertex copy = mesh.next_copy(v); copy != v; copy = mesh.next_copy(copy)) point[copy.index] = points;
    ++points;
  }
  for (const Edge e : live_edges(mesh)) edge[e.index] = edges++;
  for (const Face f : live_faces(mesh)) face[f.index] = faces++;
}

std::vector<Vertex> vertices_of(const Polygons& polygons, Face f) {
  const auto begin = polygons.corners.begin();
  return {begin + polygons.offsets[f.index], begin + polygons.offsets[f.index + 1]};
}

Polygons polygons_of(const Mesh& mesh, const Numbering& numbers) {
  Polygons polygons;
  polygons.positions.resize(numbers.points);
  for (std::uint32_t i = mesh.vertex_slots(); i-- > 0;)
    if (numbers.point[i] != no_index) polygons.positions[numbers.point[i]] = mesh.position(Vertex(i));
  for (const Face f : live_faces(mesh)) {
    for (const Halfedge h : loop(mesh, mesh.halfedge(f))) polygons.corners.push_back(numbers.point[mesh.from(h).index]);
    polygons.offsets.push_back(static_cast<std::uint32_t>(polygons.corners.size()));
  }
  return polygons;
}

std::vector<Halfedge> corner_halfedges(const Mesh& mesh) {
  std::vector<Halfedge> corners;
  for (const Face f : live_faces(mesh))
    for (const Halfedge h : loop(mesh, mesh.halfedge(f))) corners.push_back(h);
  return corners;
}

std::vector<std::uint32_t> corners_across(const Mesh& mesh) {
  const std::vector<Halfedge> corners = corner_halfedges(mesh);
  std::vector<std::uint32_t> corner_of(mesh.halfedge_slots(), no_index);
  for (std::uint32_t c = 0; c < corners.size(); ++c) corner_of[corners[c].index] = c;
  std::vector<std::uint32_t> across(corners.size());
  for (std::uint32_t c = 0; c < corners.size(); ++c) across[c] = corner_of[twin(corners[c]).index];
  return across;
}

namespace {

// The halfedge of each corner: edges are numbered by their first corner, which gets the even half.
std::vector<Halfedge> number_sides(const std::vector<std::uint32_t>& across, std::uint32_t& edges) {
  std::vector<Halfedge> side(across.size());
  for (std::uint32_t c = 0; c < side.size(); ++c)
    side[c] = across[c] < c ? twin(side[across[c]]) : halfedge(Edge(edges++));
  return side;
}

void link_gaps(MeshColumns& c) {
  auto& halfedges = c.halfedges;
  for (std::uint32_t i = 0; i < halfedges.size(); ++i)
    if (!halfedges[i].face) halfedges[i].from = halfedges[halfedges[i ^ 1u].next.index].from;
  for (std::uint32_t i = 0; i < halfedges.size(); ++i) {
    if (halfedges[i].face) continue;
    // Rotate about the end to the next gap.
    Halfedge h = twin(Halfedge(i));
    while (halfedges[h.index].face) h = twin(halfedges[h.index].prev);
    halfedges[i].next = h;
    halfedges[h.index].prev = Halfedge(i);
    c.vertex_halfedge[halfedges[i].from.index] = Halfedge(i);
  }
}

}  // namespace

Mesh mesh_from_sides(const Polygons& polygons, const std::vector<std::uint32_t>& across) {
  MeshColumns c;
  std::uint32_t edges = 0;
  const std::vector<Halfedge> side = number_sides(across, edges);
  c.positions = polygons.positions;
  c.vertex_halfedge.assign(polygons.positions.size(), Halfedge());
  c.halfedges.assign(std::size_t{2} * edges, HalfedgeLinks());
  c.face_halfedge.resize(polygons.face_count());
  for (std::uint32_t f = 0; f < polygons.face_count(); ++f) {
    const std::uint32_t begin = polygons.offsets[f], end = polygons.offsets[f + 1];
    c.face_halfedge[f] = side[begin];
    for (std::uint32_t k = begin; k < end; ++k) {
      const Vertex from(polygons.corners[k]);
      c.halfedges[side[k].index] = {from, side[k + 1 < end ? k + 1 : begin], side[k > begin ? k - 1 : end - 1],
                                    Face(f)};
      c.vertex_halfedge[from.index] = side[k];
    }
  }
  link_gaps(c);
  c.live = {static_cast<std::uint32_t>(c.positions.size()), edges, polygons.face_count(), 0};
  c.file_vertices = c.live.vertices;
  return Mesh(std::move(c));
}

Mesh without_gaps(const Mesh& mesh, const Numbering& numbers) {
  MeshColumns c;
  c.live = {numbers.vertices, numbers.edges, numbers.faces, 0};
  c.vertex_halfedge.reserve(numbers.vertices);
  c.positions.reserve(numbers.vertices);
  c.halfedges.reserve(std::size_t{2} * numbers.edges);
  c.face_halfedge.reserve(numbers.faces);
  for (const Vertex v : live_vertices(mesh)) {
    c.vertex_halfedge.push_back(numbers.halfedge(mesh.halfedge(v)));
    c.positions.push_back(mesh.position(v));
    if (mesh.has_copies()) {
      c.next_copy.emplace_back(numbers.vertex[mesh.next_copy(v).index]);
      c.copy_point.emplace_back(numbers.vertex[mesh.copy_point(v).index]);
    }
    if (v.index < mesh.file_vertices()) ++c.file_vertices;
  }
  for (const Halfedge h : live_halfedges(mesh)) {
    const Face f = mesh.face(h);
    c.halfedges.push_back({Vertex(numbers.vertex[mesh.from(h).index]), numbers.halfedge(mesh.next(h)),
                           numbers.halfedge(mesh.prev(h)), f ? Face(numbers.face[f.index]) : f});
  }
  for (const Face f : live_faces(mesh)) c.face_halfedge.push_back(numbers.halfedge(mesh.halfedge(f)));
  for (std::uint32_t i = 0; mesh.has_rings() && i < mesh.face_slots(); ++i) {
    if (!mesh.is_alive(Face(i))) continue;
    std::vector<Halfedge> starts = inner_loops(mesh, Face(i));
    for (Halfedge& start : starts) start = numbers.halfedge(start);
    set_inner_loops(c, Face(numbers.face[i]), starts);
  }
  return Mesh(std::move(c));
}

}  // namespace ryosen::forms
