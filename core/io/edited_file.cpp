#include "core/io/edited_file.h"

#include <algorithm>

#include "core/base/sort_unique.h"
#include "core/io/elements.h"

namespace ryosen {
namespace {

std::size_t count_wires(const Mesh& mesh) {
  std::size_t wires = 0;
  for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) wires += mesh.is_alive(Edge(i)) && mesh.is_wire(Edge(i));
  return wires;
}

}  // namespace

std::vector<Vertex> used_beside_the_mesh(const MeshFile& source, const FileTables& tables, std::size_t file_vertices) {
  std::vector<Vertex> used;
  const auto add = [&](std::int64_t number) {
    if (number >= 0 && number < static_cast<std::int64_t>(file_vertices))
      used.emplace_back(static_cast<std::uint32_t>(number));
  };
  for (const QuarantinedFace& face : tables.quarantine) std::for_each(face.corners.begin(), face.corners.end(), add);
  std::for_each(source.elements.vertices.begin(), source.elements.vertices.end(), add);
  for (const std::int64_t number : vertices_named(source.properties)) add(number);
  sort_unique(used);
  return used;
}

MeshFile edited_file(const MeshFile& source, const Mesh& mesh, const FileTables& tables) {
  MeshFile file = source;
  CompactMesh compact = to_indexed(mesh, tables, used_beside_the_mesh(source, tables, mesh.file_vertices()));
  const std::size_t new_vertices = compact.mesh.positions.size();
  file.elements =
      renumbered(source.elements, compact.vertex_number, compact.face_number, mesh.file_vertices(), new_vertices);
  file.properties = renumbered(source.properties, compact.vertex_number, compact.face_number, mesh.file_vertices(),
                               new_vertices, compact.mesh.face_count());
  file.kept_vertices = compact.kept_vertices;
  file.wires = count_wires(mesh);
  file.mesh = std::move(compact.mesh);
  return file;
}

}  // namespace ryosen
