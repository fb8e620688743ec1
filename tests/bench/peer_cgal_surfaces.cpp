#include "tests/bench/peer_cgal_surfaces.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>

#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>

#include "ryosen/indexed/from_indexed.h"
#include "ryosen/mesh/circulate.h"

namespace ryosen::bench {

namespace {

using PeerSurface = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
using PeerClock = std::chrono::steady_clock;

double since(PeerClock::time_point start) {
  return 1000 * std::chrono::duration<double>(PeerClock::now() - start).count();
}

IndexedMesh list_of(const PeerSurface& mesh) {
  IndexedMesh list;
  std::vector<std::uint32_t> number(mesh.num_vertices() + mesh.number_of_removed_vertices());
  for (const auto v : mesh.vertices()) {
    number[v] = static_cast<std::uint32_t>(list.positions.size());
    list.positions.emplace_back(mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z());
  }
  for (const auto f : mesh.faces()) {
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f))) list.corners.push_back(number[v]);
    list.face_offsets.push_back(static_cast<std::uint32_t>(list.corners.size()));
  }
  return list;
}

}  // namespace

SurfaceQuality quality_of(const Mesh& mesh, double wanted_length) {
  SurfaceQuality quality;
  quality.faces = mesh.live().faces;
  quality.smallest_angle_deg = 180;
  double sum = 0, squares = 0, count = 0;
  for (std::uint32_t i = 0; i < mesh.halfedge_slots(); ++i) {
    if (!mesh.is_alive(Halfedge(i))) continue;
    const double length =
        glm::distance(mesh.position(mesh.from(Halfedge(i))), mesh.position(mesh.to(Halfedge(i)))) / wanted_length;
    sum += length;
    squares += length * length;
    ++count;
  }
  quality.mean_length = sum / count;
  quality.spread = std::sqrt(std::max(0.0, squares / count - quality.mean_length * quality.mean_length));
  for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
    if (!mesh.is_alive(Face(i))) continue;
    double smallest = 180;
    for (const Halfedge h : loop(mesh, mesh.halfedge(Face(i)))) {
      const glm::dvec3 a = mesh.position(mesh.from(h)), b = mesh.position(mesh.to(h)),
                       c = mesh.position(mesh.from(mesh.prev(h)));
      smallest = std::min(
          smallest, std::atan2(glm::length(glm::cross(b - a, c - a)), glm::dot(b - a, c - a)) * 57.29577951308232);
    }
    quality.smallest_angle_deg = std::min(quality.smallest_angle_deg, smallest);
    quality.mean_angle_deg += smallest / quality.faces;
    quality.narrow += smallest < 30 ? 1.0 / quality.faces : 0;
  }
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i) {
    const Vertex v(i);
    if (!mesh.is_alive(v) || mesh.is_isolated(v)) continue;
    int valence = 0;
    for ([[maybe_unused]] const Halfedge h : outgoing(mesh, v)) ++valence;
    quality.valence_six += valence == 6 ? 1.0 / mesh.live().vertices : 0;
    quality.valence_near_six += valence >= 5 && valence <= 7 ? 1.0 / mesh.live().vertices : 0;
  }
  return quality;
}

struct SurfacesPeer::Data {
  PeerSurface mesh;
};

SurfacesPeer::SurfacesPeer(const IndexedMesh& source) : data_(std::make_unique<Data>()) {
  for (const glm::dvec3& p : source.positions) data_->mesh.add_vertex({p.x, p.y, p.z});
  std::vector<PeerSurface::Vertex_index> corners;
  for (std::size_t f = 0; f < source.face_count(); ++f) {
    corners.clear();
    for (const std::uint32_t corner : source.face(f)) corners.emplace_back(corner);
    data_->mesh.add_face(corners);
  }
}

SurfacesPeer::~SurfacesPeer() = default;

double SurfacesPeer::milliseconds_of_step(char scheme) const {
  PeerSurface copy = data_->mesh;
  const auto once = CGAL::parameters::number_of_iterations(1);
  const auto start = PeerClock::now();
  if (scheme == 'L') CGAL::Subdivision_method_3::Loop_subdivision(copy, once);
  if (scheme == 'C') CGAL::Subdivision_method_3::CatmullClark_subdivision(copy, once);
  if (scheme == 's') CGAL::Subdivision_method_3::Sqrt3_subdivision(copy, once);
  return since(start);
}

double SurfacesPeer::milliseconds_of_remeshing(double length, unsigned rounds, IndexedMesh& made) const {
  PeerSurface copy = data_->mesh;
  const auto start = PeerClock::now();
  CGAL::Polygon_mesh_processing::isotropic_remeshing(copy.faces(), length, copy,
                                                     CGAL::parameters::number_of_iterations(rounds));
  const double time = since(start);
  made = list_of(copy);
  return time;
}

}  // namespace ryosen::bench
