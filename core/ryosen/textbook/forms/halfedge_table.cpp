#include "ryosen/textbook/forms/halfedge_table.h"

#include <utility>

#include "ryosen/mesh/live_elements.h"
#include "ryosen/textbook/forms/polygons.h"
#include "ryosen/textbook/forms/walk.h"

namespace ryosen::forms {

std::size_t HalfedgeTable::bytes() const {
  return bytes_of(positions) + bytes_of(vertex_halfedge) + bytes_of(halfedges) + bytes_of(face_halfedge);
}

HalfedgeTable inner_halfedges(const Mesh& mesh) {
  const Numbering numbers(mesh);
  const Polygons polygons = polygons_of(mesh, numbers);
  const std::vector<std::uint32_t> across = corners_across(mesh);
  HalfedgeTable table;
  table.positions = polygons.positions;
  table.vertex_halfedge.assign(polygons.positions.size(), no_index);
  table.halfedges.resize(polygons.corners.size());
  for (std::uint32_t f = 0; f < polygons.face_count(); ++f) {
    const std::uint32_t begin = polygons.offsets[f], end = polygons.offsets[f + 1];
    table.face_halfedge.push_back(begin);
    for (std::uint32_t c = begin; c < end; ++c) {
      const std::uint32_t v = polygons.corners[c];
      table.halfedges[c] = {v, f, across[c], c + 1 < end ? c + 1 : begin, c > begin ? c - 1 : end - 1};
      if (table.vertex_halfedge[v] == no_index) table.vertex_halfedge[v] = c;
    }
  }
  return table;
}

HalfedgeTable all_halfedges(const Mesh& mesh) {
  const Numbering numbers(mesh);
  const auto number = [&](Halfedge h) { return numbers.halfedge(h).index; };
  HalfedgeTable table;
  for (const Vertex v : live_vertices(mesh)) {
    table.positions.push_back(mesh.position(v));
    table.vertex_halfedge.push_back(number(mesh.halfedge(v)));
  }
  for (const Halfedge h : live_halfedges(mesh)) {
    const Face f = mesh.face(h);
    table.halfedges.push_back({numbers.vertex[mesh.from(h).index], f ? numbers.face[f.index] : no_index,
                               number(twin(h)), number(mesh.next(h)), number(mesh.prev(h))});
  }
  for (const Face f : live_faces(mesh)) table.face_halfedge.push_back(number(mesh.halfedge(f)));
  return table;
}

Mesh mesh_from_inner_halfedges(const HalfedgeTable& table) {
  Polygons polygons;
  polygons.positions = table.positions;
  std::vector<std::uint32_t> corner_of(table.halfedges.size(), no_index), halfedge_of;
  for (const std::uint32_t first : table.face_halfedge) {
    for_each_in_loop(table, first, [&](std::uint32_t h) {
      corner_of[h] = static_cast<std::uint32_t>(polygons.corners.size());
      halfedge_of.push_back(h);
      polygons.corners.push_back(table.from(h));
    });
    polygons.offsets.push_back(static_cast<std::uint32_t>(polygons.corners.size()));
  }
  std::vector<std::uint32_t> across;
  for (const std::uint32_t h : halfedge_of)
    across.push_back(table.pair(h) == no_index ? no_index : corner_of[table.pair(h)]);
  return mesh_from_sides(polygons, across);
}

Mesh mesh_from_all_halfedges(const HalfedgeTable& table, const std::vector<std::vector<std::uint32_t>>& inner) {
  std::vector<Halfedge> slot(table.halfedges.size());
  std::uint32_t edges = 0;
  for (std::uint32_t h = 0; h < slot.size(); ++h)
    slot[h] = table.pair(h) < h ? twin(slot[table.pair(h)]) : halfedge(Edge(edges++));
  const auto slot_of = [&](std::uint32_t h) { return h == no_index ? Halfedge() : slot[h]; };
  MeshColumns c;
  c.positions = table.positions;
  for (const std::uint32_t h : table.vertex_halfedge) c.vertex_halfedge.push_back(slot_of(h));
  for (const std::uint32_t h : table.face_halfedge) c.face_halfedge.push_back(slot_of(h));
  c.halfedges.resize(slot.size());
  for (std::uint32_t h = 0; h < slot.size(); ++h) {
    const std::uint32_t face = table.face(h);
    c.halfedges[slot[h].index] = {Vertex(table.from(h)), slot[table.next(h)], slot[table.prev(h)],
                                  face == no_index ? Face() : Face(face)};
  }
  c.live = {static_cast<std::uint32_t>(c.positions.size()), edges, static_cast<std::uint32_t>(c.face_halfedge.size()),
            0};
  for (std::uint32_t f = 0; f < inner.size(); ++f) {
    std::vector<Halfedge> starts;
    for (const std::uint32_t h : inner[f]) starts.push_back(slot[h]);
    set_inner_loops(c, Face(f), starts);
  }
  c.file_vertices = c.live.vertices;
  return Mesh(std::move(c));
}

}  // namespace ryosen::forms
