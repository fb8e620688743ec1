#include "core/io/edited_file.h"

#include "core/io/elements.h"

namespace ryosen {
namespace {

std::size_t count_wires(const Mesh& mesh) {
  std::size_t wires = 0;
  for (std::uint32_t i = 0; i < mesh.edge_slots(); ++i) wires += mesh.is_alive(Edge(i)) && mesh.is_wire(Edge(i));
  return wires;
}

}  // namespace

MeshFile edited_file(const MeshFile& source, const Mesh& mesh, const FileTables& tables) {
  MeshFile file = source;
  CompactMesh compact = to_indexed(mesh, tables);
  const std::size_t new_vertices = compact.mesh.positions.size();
  file.elements =
      renumbered(source.elements, compact.vertex_number, compact.face_number, mesh.file_vertices(), new_vertices);
  file.properties = renumbered(source.properties, compact.vertex_number, compact.face_number, mesh.file_vertices(),
                               new_vertices, compact.mesh.face_count());
  file.wires = count_wires(mesh);
  file.mesh = std::move(compact.mesh);
  return file;
}

}  // namespace ryosen
