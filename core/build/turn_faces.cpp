#include "core/build/turn_faces.h"

#include <algorithm>

#include "core/build/from_indexed.h"
#include "core/mesh/circulate.h"
#include "core/mesh/copies.h"

namespace ryosen {

namespace {

// The halfedge of every corner, face after face, turned faces backwards from the same first corner.
std::vector<Halfedge> corners_of(const Mesh& mesh, const std::vector<bool>& turned,
                                 std::vector<std::uint32_t>& offsets) {
  std::vector<Halfedge> corners;
  offsets = {0};
  for (std::uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (mesh.is_alive(Face(f))) {
      const auto begin = static_cast<std::ptrdiff_t>(corners.size());
      for (Halfedge h : halfedges_around(mesh, Face(f))) corners.push_back(h);
      if (turned[f]) std::reverse(corners.begin() + begin + 1, corners.end());
    }
    offsets.push_back(static_cast<std::uint32_t>(corners.size()));
  }
  return corners;
}

void carry_attributes(const Mesh& mesh, const std::vector<Halfedge>& corners, const std::vector<std::uint32_t>& offsets,
                      const Mesh& turned, MeshColumns& c) {
  for (const AttributeColumn& old : mesh.attributes()) {
    AttributeColumn column = old;
    if (old.element == ElementKind::vertex) {
      for (std::uint32_t v = mesh.vertex_slots(); v < turned.vertex_slots(); ++v) {
        const auto* value = old.data.data() + std::size_t{point(turned, Vertex(v)).index} * old.words;
        column.data.insert(column.data.end(), value, value + old.words);
      }
    } else if (old.element == ElementKind::corner) {
      column.data.clear();
      for (std::uint32_t h = 0; h < turned.halfedge_slots(); ++h)
        column.data.insert(column.data.end(), old.fill.begin(), old.fill.end());
      for (std::uint32_t f = 0; f + 1 < offsets.size(); ++f) {
        if (offsets[f] == offsets[f + 1]) continue;
        std::uint32_t i = offsets[f];
        for (Halfedge h : halfedges_around(turned, Face(f))) {
          const auto* value = old.data.data() + std::size_t{corners[i++].index} * old.words;
          std::copy(value, value + old.words,
                    column.data.begin() + static_cast<std::ptrdiff_t>(std::size_t{h.index} * old.words));
        }
      }
    }
    c.attributes.push_back(std::move(column));
  }
}

}  // namespace

MeshColumns turn_faces(const Mesh& mesh, const std::vector<bool>& turned) {
  IndexedMesh source;
  const std::vector<Halfedge> corners = corners_of(mesh, turned, source.face_offsets);
  source.positions.assign(mesh.positions().begin(), mesh.positions().end());
  for (Halfedge h : corners) source.corners.push_back(point(mesh, mesh.from(h)).index);
  const std::vector<std::uint32_t> offsets = source.face_offsets;
  const Mesh connected = from_indexed(std::move(source));

  MeshColumns c = connected.columns();
  carry_attributes(mesh, corners, offsets, connected, c);
  c.file_vertices = mesh.file_vertices();
  c.live.faces = mesh.live().faces;
  // Slots that were dead, and copies that are no longer needed, hold dead numbers.
  for (std::uint32_t v = 0; v < mesh.vertex_slots(); ++v) {
    if (mesh.is_alive(Vertex(v)) && point(mesh, Vertex(v)) == Vertex(v)) continue;
    c.vertex_halfedge[v] = dead_halfedge;
    --c.live.vertices;
  }
  return c;
}

}  // namespace ryosen
