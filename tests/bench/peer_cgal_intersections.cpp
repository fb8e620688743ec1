#include "tests/bench/peer_cgal_intersections.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

#include <memory>
#include <utility>
#include <vector>

namespace ryosen::bench {

std::function<std::size_t()> cgal_intersections(const IndexedMesh& source) {
  using SurfaceMesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
  auto mesh = std::make_shared<SurfaceMesh>();
  for (const glm::dvec3& p : source.positions) mesh->add_vertex({p.x, p.y, p.z});
  for (std::size_t f = 0; f < source.face_count(); ++f) {
    std::vector<SurfaceMesh::Vertex_index> corners;
    for (const std::uint32_t corner : source.face(f)) corners.emplace_back(corner);
    mesh->add_face(corners);
  }
  return [mesh] {
    std::vector<std::pair<SurfaceMesh::Face_index, SurfaceMesh::Face_index>> pairs;
    CGAL::Polygon_mesh_processing::self_intersections(*mesh, std::back_inserter(pairs));
    return pairs.size();
  };
}

}  // namespace ryosen::bench
