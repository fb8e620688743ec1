#include "ryosen/algo/subdivide/prepare.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "ryosen/algo/features.h"
#include "ryosen/algo/preparation.h"
#include "ryosen/geometry/polygon_normal.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/face_polygon.h"
#include "ryosen/mesh/live_elements.h"
#include "ryosen/ops/poke.h"

namespace ryosen::subdivide {

namespace {

bool takes_triangles(Scheme scheme) { return scheme == Scheme::loop || scheme == Scheme::sqrt3; }

std::vector<Face> faces_to_cut(const Mesh& mesh, Scheme scheme) {
  std::vector<Face> found = polygons_of_mesh(mesh);
  if (!takes_triangles(scheme))
    std::erase_if(found, [&](Face f) { return !mesh.has_rings(f) && !has_bridge(mesh, f); });
  return found;
}

// Of two triangles with two common edges the later: dividing both would join the middles of these edges twice.
std::vector<Face> folded_triangles(const Mesh& mesh) {
  std::vector<Face> found;
  for (const Face f : live_faces(mesh)) {
    const Halfedge h = mesh.halfedge(f), next = mesh.next(h);
    const Face a = mesh.face(twin(h)), b = mesh.face(twin(next)), c = mesh.face(twin(mesh.next(next)));
    const Face other = a == b || a == c ? a : b == c ? b : Face();
    if (other && other.index < f.index) found.push_back(f);
  }
  return found;
}

std::optional<Text> cut(Mesh& mesh, std::span<const Face> faces, Scheme scheme, std::size_t& count, Descent* descent) {
  Edit edit(mesh, nullptr, descent);
  std::optional<Text> fault = cut_faces(edit, faces);
  count = faces.size();
  if (!fault && takes_triangles(scheme))
    for (const Face f : folded_triangles(mesh)) {
      poke(edit, f, Poke{f}.position(mesh));
      ++count;
    }
  edit.commit();
  return fault;
}

void mark_bent_edges(const Mesh& mesh, double angle_rad, float sharpness, std::vector<float>& column) {
  std::vector<glm::dvec3> normals(mesh.face_slots(), glm::dvec3(0));
  for (const Face f : live_faces(mesh)) normals[f.index] = polygon_normal(FacePolygon(mesh, f).keyhole_walk());
  const double least = std::cos(angle_rad);
  for (const Edge e : live_edges(mesh)) {
    const auto [a, b] = faces(mesh, e);
    if (!a || !b || a == b) continue;
    const glm::dvec3 &n = normals[a.index], &m = normals[b.index];
    const bool have_normals = glm::dot(n, n) > 0.5 && glm::dot(m, m) > 0.5;
    if (have_normals && glm::dot(n, m) <= least) column[e.index] = sharpness;
  }
}

// What is sharp on the mesh as it is given.
Creases creases_of(const Mesh& mesh, const Options& options) {
  Creases creases;
  std::vector<std::uint8_t> corners(mesh.vertex_slots(), 0);
  const bool names_edges = std::any_of(options.sharp.begin(), options.sharp.end(), [](const Element& e) {
    return e.kind == Element::Kind::edge || e.kind == Element::Kind::halfedge;
  });
  const float sharpness = options.sharp_steps ? static_cast<float>(*options.sharp_steps) : always_sharp;
  if (names_edges || options.crease_angle_rad) creases.sharpness.assign(mesh.edge_slots(), 0);
  if (options.crease_angle_rad) mark_bent_edges(mesh, *options.crease_angle_rad, sharpness, creases.sharpness);
  for (const Element& e : options.sharp) {
    if (e.kind == Element::Kind::vertex) corners[e.vertex().index] = 1;
    if (e.kind == Element::Kind::edge) creases.sharpness[e.edge().index] = sharpness;
    if (e.kind == Element::Kind::halfedge) creases.sharpness[edge(e.halfedge()).index] = sharpness;
  }
  for (const Vertex v : live_vertices(mesh))
    if (!mesh.is_isolated(v) && (has_copies(mesh, v) || ends_a_wire_or_fan(mesh, v))) corners[v.index] = 1;
  if (std::any_of(corners.begin(), corners.end(), [](std::uint8_t c) { return c != 0; }))
    creases.corners = std::move(corners);
  return creases;
}

// A triangle of the sqrt(3) scheme lies across an edge, which a torn texture does not allow.
std::size_t mark_seams(const Mesh& mesh, Creases& creases) {
  std::size_t found = 0;
  if (corner_attributes(mesh).empty()) return found;
  for (const Edge e : live_edges(mesh)) {
    const Halfedge h = halfedge(e);
    if (mesh.is_outside(h) || mesh.is_outside(twin(h))) continue;
    if (!corner_values_differ(mesh, h, twin(h), false)) continue;
    if (creases.sharpness.empty()) creases.sharpness.assign(mesh.edge_slots(), 0);
    found += creases.sharpness[e.index] == always_sharp ? 0 : 1;
    creases.sharpness[e.index] = always_sharp;
  }
  return found;
}

// Edges and their corners get other numbers, dead ones none.
void tell_numbers(std::span<const std::uint32_t> number, std::uint32_t count, Descent& descent) {
  SourceList edges(count), corners(2 * std::size_t{count});
  for (std::uint32_t e = 0; e < number.size(); ++e) {
    if (number[e] == no_index) continue;
    edges.keep(number[e], e);
    for (const std::uint32_t side : {0u, 1u}) corners.keep(2 * number[e] + side, 2 * e + side);
  }
  descent.follow(ElementKind::edge, edges);
  if (Descent::records(ElementKind::corner)) descent.follow(ElementKind::corner, corners);
}

// The columns of a mesh with its dead edges left out, and the values per edge with them.
void drop_dead_edges(MeshColumns& c, std::vector<float>& sharpness, Descent* descent) {
  std::vector<std::uint32_t> number(c.halfedges.size() / 2, no_index);
  std::uint32_t kept = 0;
  for (std::size_t e = 0; e < number.size(); ++e)
    if (c.halfedges[2 * e].from != dead_from) number[e] = kept++;
  const auto renamed = [&](Halfedge h) {
    return h.is_none() || h == dead_halfedge ? h : halfedge(Edge(number[edge(h).index]), h.index & 1u);
  };
  for (std::size_t e = 0; e < number.size(); ++e) {
    if (number[e] == no_index) continue;
    for (std::size_t side = 0; side < 2; ++side) {
      const HalfedgeLinks& l = c.halfedges[2 * e + side];
      c.halfedges[2 * std::size_t{number[e]} + side] = {l.from, renamed(l.next), renamed(l.prev), l.face};
    }
    if (!sharpness.empty()) sharpness[number[e]] = sharpness[e];
    for (AttributeColumn& a : c.attributes) {
      if (number[e] == e || (a.element != ElementKind::corner && a.element != ElementKind::edge)) continue;
      const std::size_t words = a.element == ElementKind::edge ? a.words() : 2 * std::size_t{a.words()};
      const std::uint32_t* const from = a.data.data() + e * words;
      std::copy(from, from + words, a.data.data() + number[e] * words);
    }
  }
  c.halfedges.resize(2 * std::size_t{kept});
  if (!sharpness.empty()) sharpness.resize(kept);
  if (descent) tell_numbers(number, kept, *descent);
  for (AttributeColumn& a : c.attributes)
    if (a.element == ElementKind::corner || a.element == ElementKind::edge)
      a.data.resize(std::size_t{kept} * (a.element == ElementKind::edge ? 1 : 2) * a.words());
  for (Halfedge& h : c.vertex_halfedge) h = renamed(h);
  for (Halfedge& h : c.face_halfedge) h = renamed(h);
}

// The second face of the edge gets an edge of its own; the two have a gap of two halfedges between them.
void open_edge(MeshColumns& c, Edge e) {
  const Halfedge h = halfedge(e), t = twin(h), own(c.halfedges.size()), gap = twin(own);
  const HalfedgeLinks moved = c.halfedges[t.index];
  const Vertex a = c.halfedges[h.index].from, b = moved.from;
  c.halfedges.push_back(moved);
  c.halfedges.push_back({a, t, t, Face()});
  c.halfedges[moved.prev.index].next = own;
  c.halfedges[moved.next.index].prev = own;
  c.halfedges[t.index] = {b, gap, gap, Face()};
  c.vertex_halfedge[a.index] = gap;
  c.vertex_halfedge[b.index] = t;
  if (c.face_halfedge[moved.face.index] == t) c.face_halfedge[moved.face.index] = own;
  for (AttributeColumn& column : c.attributes) {
    if (column.element == ElementKind::edge) {
      const auto begin = column.data.begin() + std::ptrdiff_t{e.index} * column.words();
      const std::vector<std::uint32_t> same(begin, begin + column.words());
      column.data.insert(column.data.end(), same.begin(), same.end());
    }
    if (column.element != ElementKind::corner) continue;
    const std::size_t place = std::size_t{t.index} * column.words();
    const std::vector<std::uint32_t> words(column.data.begin() + static_cast<std::ptrdiff_t>(place),
                                           column.data.begin() + static_cast<std::ptrdiff_t>(place + column.words()));
    column.data.insert(column.data.end(), words.begin(), words.end());
    column.data.insert(column.data.end(), column.fill.begin(), column.fill.end());
    std::copy(column.fill.begin(), column.fill.end(), column.data.begin() + static_cast<std::ptrdiff_t>(place));
  }
  ++c.live.edges;
}

std::vector<Edge> edges_to_open(const Mesh& mesh) {
  std::vector<Edge> found;
  for (const Edge e : sheet_groups(mesh).edges)
    if (const auto [a, b] = faces(mesh, e); a && b) found.push_back(e);
  return found;
}

// Each opened edge became two, of which the second is the last edge so far and has the corner of the second face.
void tell_opened(std::size_t before, std::span<const Edge> opened, Descent& descent) {
  SourceList edges = SourceList::kept(before, opened.size()), corners = SourceList::kept(2 * before, 2 * opened.size());
  Edge own(before);
  for (const Edge e : opened) {
    edges.part(e.index, e.index, 1);
    edges.part(own.index, e.index, 1);
    corners.keep(halfedge(own).index, twin(halfedge(e)).index);
    corners.fresh(twin(halfedge(e)).index);
    ++own.index;
  }
  descent.follow(ElementKind::edge, edges);
  if (Descent::records(ElementKind::corner)) descent.follow(ElementKind::corner, corners);
}

}  // namespace

std::optional<Mesh> with_open_sheets(const Mesh& mesh, Creases& creases, Descent* descent) {
  const std::vector<Edge> shut = edges_to_open(mesh);
  if (shut.empty()) return std::nullopt;
  MeshColumns columns = mesh.columns();
  for (const Edge e : shut) open_edge(columns, e);
  if (!creases.sharpness.empty()) creases.sharpness.resize(columns.halfedges.size() / 2, 0);
  if (descent) tell_opened(mesh.edge_slots(), shut, *descent);
  return Mesh(std::move(columns));
}

void mark_shut_sheets(const Mesh& mesh, Creases& creases) {
  for (const Edge e : edges_to_open(mesh)) {
    if (creases.sharpness.empty()) creases.sharpness.assign(mesh.edge_slots(), 0);
    creases.sharpness[e.index] = always_sharp;
  }
}

Prepared prepare(const Mesh& mesh, const Options& options, Descent* descent) {
  Prepared prepared;
  const std::vector<Face> to_cut = faces_to_cut(mesh, options.scheme);
  prepared.creases = creases_of(mesh, options);
  Creases& creases = prepared.creases;
  const bool is_folded = takes_triangles(options.scheme) && to_cut.empty() && !folded_triangles(mesh).empty();
  if (!to_cut.empty() || is_folded || mesh.live().edges != mesh.edge_slots()) {
    prepared.changed = mesh;
    prepared.fault = cut(*prepared.changed, to_cut, options.scheme, prepared.cut_faces, descent);
    if (prepared.fault) return prepared;
    if (!creases.sharpness.empty()) creases.sharpness.resize(prepared.changed->edge_slots(), 0);
    if (!creases.corners.empty()) creases.corners.resize(prepared.changed->vertex_slots(), 0);
    MeshColumns columns = prepared.changed->columns();
    columns.first_ring.clear();
    columns.rings.clear();
    drop_dead_edges(columns, creases.sharpness, descent);
    prepared.changed = Mesh(std::move(columns));
  }
  if (options.scheme == Scheme::sqrt3)
    prepared.seams = mark_seams(prepared.changed ? *prepared.changed : mesh, creases);
  return prepared;
}

}  // namespace ryosen::subdivide
