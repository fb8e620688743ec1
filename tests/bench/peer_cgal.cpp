#include "tests/bench/peer_cgal.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>

#include <algorithm>
#include <array>

namespace ryosen::bench {

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;
using SurfaceMesh = CGAL::Surface_mesh<Point>;
using EdgeIndex = SurfaceMesh::Edge_index;
using VertexIndex = SurfaceMesh::Vertex_index;

bool is_swappable(const SurfaceMesh& mesh, EdgeIndex e) {
  const auto h = mesh.halfedge(e), o = mesh.opposite(h);
  if (mesh.is_border(h) || mesh.is_border(o)) return false;
  const VertexIndex c = mesh.target(mesh.next(h)), d = mesh.target(mesh.next(o));
  return c != d && mesh.halfedge(c, d) == SurfaceMesh::null_halfedge();
}

}  // namespace

struct CgalMesh::Data {
  SurfaceMesh mesh;
};

CgalMesh::CgalMesh() : data_(std::make_unique<Data>()) {}
CgalMesh::~CgalMesh() = default;
CgalMesh::CgalMesh(CgalMesh&&) noexcept = default;
CgalMesh& CgalMesh::operator=(CgalMesh&&) noexcept = default;

CgalMesh CgalMesh::copy() const {
  CgalMesh result;
  *result.data_ = *data_;
  return result;
}

CgalMesh CgalMesh::build(const IndexedMesh& source) {
  CgalMesh result;
  SurfaceMesh& mesh = result.data_->mesh;
  const auto vertices = static_cast<SurfaceMesh::size_type>(source.positions.size()),
             faces = static_cast<SurfaceMesh::size_type>(source.face_count());
  mesh.reserve(vertices, vertices + faces, faces);
  for (const glm::dvec3& p : source.positions) mesh.add_vertex(Point(p.x, p.y, p.z));
  std::vector<VertexIndex> corners;
  for (std::size_t f = 0; f < source.face_count(); ++f) {
    corners.clear();
    for (std::uint32_t corner : source.face(f)) corners.emplace_back(corner);
    mesh.add_face(corners);
  }
  return result;
}

CgalMesh CgalMesh::read(const std::string& path) {
  CgalMesh result;
  CGAL::IO::read_polygon_mesh(path, result.data_->mesh, CGAL::parameters::use_binary_mode(true));
  return result;
}

std::size_t CgalMesh::faces() const { return data_->mesh.number_of_faces(); }
std::size_t CgalMesh::edges() const { return data_->mesh.number_of_edges() + data_->mesh.number_of_removed_edges(); }

void CgalMesh::sum_one_rings_over_edges(std::vector<glm::dvec3>& sums) const {
  const SurfaceMesh& mesh = data_->mesh;
  std::fill(sums.begin(), sums.end(), glm::dvec3(0));
  for (const auto e : mesh.edges()) {
    const VertexIndex a = mesh.vertex(e, 0), b = mesh.vertex(e, 1);
    const Point &p = mesh.point(a), &q = mesh.point(b);
    sums[a] += glm::dvec3(q.x(), q.y(), q.z());
    sums[b] += glm::dvec3(p.x(), p.y(), p.z());
  }
}

double CgalMesh::walk_one_rings() const {
  const SurfaceMesh& mesh = data_->mesh;
  double x = 0, y = 0, z = 0;
  for (VertexIndex v : mesh.vertices()) {
    if (mesh.is_isolated(v)) continue;
    for (VertexIndex neighbour : mesh.vertices_around_target(mesh.halfedge(v))) {
      const Point& p = mesh.point(neighbour);
      x += p.x();
      y += p.y();
      z += p.z();
    }
  }
  return x + y + z;
}

std::size_t CgalMesh::count_collapsible() const {
  std::size_t count = 0;
  for (EdgeIndex e : data_->mesh.edges()) count += CGAL::Euler::does_satisfy_link_condition(e, data_->mesh);
  return count;
}

std::size_t CgalMesh::count_swappable() const {
  std::size_t count = 0;
  for (EdgeIndex e : data_->mesh.edges()) count += is_swappable(data_->mesh, e);
  return count;
}

std::size_t CgalMesh::swap_each(const std::vector<std::uint32_t>& edges) {
  SurfaceMesh& mesh = data_->mesh;
  std::size_t count = 0;
  for (std::uint32_t i : edges) {
    const EdgeIndex e(i);
    if (!is_swappable(mesh, e)) continue;
    CGAL::Euler::flip_edge(mesh.halfedge(e), mesh);
    ++count;
  }
  return count;
}

std::size_t CgalMesh::collapse_each(const std::vector<std::uint32_t>& edges) {
  SurfaceMesh& mesh = data_->mesh;
  std::size_t count = 0;
  for (std::uint32_t i : edges) {
    const EdgeIndex e(i);
    if (mesh.is_removed(e) || !CGAL::Euler::does_satisfy_link_condition(e, mesh)) continue;
    CGAL::Euler::collapse_edge(e, mesh);
    ++count;
  }
  return count;
}

}  // namespace ryosen::bench
