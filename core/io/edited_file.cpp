#include "core/io/edited_file.h"

#include <algorithm>
#include <set>

#include "core/base/sort_unique.h"
#include "core/io/elements.h"
#include "core/mesh/circulate.h"

namespace ryosen {
namespace {

// Without wires that coincide with lines, so that they do not occur twice when the file is read again.
std::vector<std::pair<std::uint32_t, std::uint32_t>> wires_beside(const ElementList& lines, const Mesh& mesh,
                                                                  const std::vector<std::uint32_t>& number) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> wires;
  for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) {
    if (!mesh.is_alive(Edge(i)) || !mesh.is_wire(Edge(i))) continue;
    const auto [a, b] = ends(mesh, Edge(i));
    wires.push_back(std::minmax(number[a.index], number[b.index]));
  }
  if (wires.empty()) return wires;
  sort_unique(wires);
  std::set<std::pair<std::int64_t, std::int64_t>> drawn;
  for (const LineElement& item : lines.items)
    for (std::uint32_t i = 1; !item.is_points && i < item.count; ++i)
      drawn.insert(std::minmax(lines.vertices[item.first + i - 1], lines.vertices[item.first + i]));
  std::erase_if(wires, [&](const auto& wire) { return drawn.contains(wire); });
  return wires;
}

}  // namespace

std::vector<Vertex> used_beside_the_mesh(const MeshFile& source, std::span<const QuarantinedFace> quarantine,
                                         std::size_t file_vertices) {
  std::vector<Vertex> used;
  const auto add = [&](std::int64_t number) {
    if (number >= 0 && number < static_cast<std::int64_t>(file_vertices))
      used.emplace_back(static_cast<std::uint32_t>(number));
  };
  for (const QuarantinedFace& face : quarantine) std::for_each(face.corners.begin(), face.corners.end(), add);
  std::for_each(source.elements.vertices.begin(), source.elements.vertices.end(), add);
  for (const std::int64_t number : vertices_named(source.properties)) add(number);
  sort_unique(used);
  return used;
}

MeshFile edited_file(const MeshFile& source, const Mesh& mesh, const FileTables& tables) {
  MeshFile file = source;
  CompactMesh compact = to_indexed(mesh, tables, used_beside_the_mesh(source, tables.quarantine, mesh.file_vertices()));
  const std::size_t new_vertices = compact.mesh.positions.size();
  file.elements =
      renumbered(source.elements, compact.vertex_number, compact.face_number, mesh.file_vertices(), new_vertices);
  file.properties = renumbered(source.properties, compact.vertex_number, compact.face_number, mesh.file_vertices(),
                               new_vertices, compact.mesh.face_count());
  file.kept_vertices = compact.kept_vertices;
  file.wires = wires_beside(file.elements, mesh, compact.vertex_number);
  file.mesh = std::move(compact.mesh);
  return file;
}

}  // namespace ryosen
