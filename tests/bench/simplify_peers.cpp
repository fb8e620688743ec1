// What others make of a mesh, for tests/bench/quality.sh.
//   simplify_peers meshoptimizer|garland-heckbert|lindstrom-turk INPUT.off OUTPUT.off FACES
// Prints the seconds that it took without reading and writing.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_placement.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <meshoptimizer.h>

#include <cfloat>
#include <chrono>

#include "tests/bench/plain_off.h"

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace simplification = CGAL::Surface_mesh_simplification;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

SurfaceMesh to_cgal(const plain::Triangles& mesh) {
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> faces;
  for (const auto& p : mesh.points) points.emplace_back(p[0], p[1], p[2]);
  for (const auto& f : mesh.faces) faces.push_back({f[0], f[1], f[2]});
  CGAL::Polygon_mesh_processing::orient_polygon_soup(points, faces);  // doubles what is not manifold
  SurfaceMesh result;
  CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, faces, result);
  return result;
}

plain::Triangles from_cgal(const SurfaceMesh& mesh) {
  plain::Triangles result;
  std::vector<std::uint32_t> number(mesh.number_of_vertices() + mesh.number_of_removed_vertices(), 0);
  for (const auto v : mesh.vertices()) {
    number[v.idx()] = static_cast<std::uint32_t>(result.points.size());
    result.points.push_back({mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()});
  }
  for (const auto f : mesh.faces()) {
    std::array<std::uint32_t, 3> face{};
    std::size_t i = 0;
    for (const auto v : mesh.vertices_around_face(mesh.halfedge(f))) face[i++ % 3] = number[v.idx()];
    result.faces.push_back(face);
  }
  return result;
}

// Stops by faces: at a number of edges that leaves as many is not known before.
struct FacesLeft {
  std::size_t wanted;
  template <class Cost, class Profile>
  bool operator()(const Cost&, const Profile& profile, std::size_t, std::size_t) const {
    return profile.surface_mesh().number_of_faces() <= wanted;  // num_faces() counts removed ones too
  }
};

double with_cgal(plain::Triangles& mesh, std::size_t faces, bool by_quadrics) {
  SurfaceMesh surface = to_cgal(mesh);
  const Clock::time_point begin = Clock::now();
  if (by_quadrics) {
    using Policies = simplification::GarlandHeckbert_plane_policies<SurfaceMesh, Kernel>;
    Policies policies(surface);
    simplification::Bounded_normal_change_placement<Policies::Get_placement> placement(policies.get_placement());
    simplification::edge_collapse(surface, FacesLeft{faces},
                                  CGAL::parameters::get_cost(policies.get_cost()).get_placement(placement));
  } else {
    simplification::edge_collapse(surface, FacesLeft{faces});
  }
  const double seconds = seconds_since(begin);
  mesh = from_cgal(surface);
  return seconds;
}

double with_meshoptimizer(plain::Triangles& mesh, std::size_t faces) {
  std::vector<float> places;
  for (const auto& p : mesh.points)
    for (const double x : p) places.push_back(static_cast<float>(x));
  std::vector<unsigned int> indices;
  for (const auto& f : mesh.faces) indices.insert(indices.end(), f.begin(), f.end());
  const Clock::time_point begin = Clock::now();
  std::vector<unsigned int> left(indices.size());
  left.resize(meshopt_simplify(left.data(), indices.data(), indices.size(), places.data(), mesh.points.size(),
                               3 * sizeof(float), 3 * faces, FLT_MAX, 0u, nullptr));
  const double seconds = seconds_since(begin);
  mesh.faces.clear();
  for (std::size_t i = 0; i < left.size(); i += 3) mesh.faces.push_back({left[i], left[i + 1], left[i + 2]});
  return seconds;
}

}  // namespace

int main(int count, char** words) {
  if (count != 5) return 2;
  const std::string method = words[1];
  plain::Triangles mesh = plain::read_off(words[2]);
  const auto faces = static_cast<std::size_t>(std::atoll(words[4]));
  const double seconds = method == "meshoptimizer" ? with_meshoptimizer(mesh, faces)
                                                   : with_cgal(mesh, faces, method == "garland-heckbert");
  plain::write_off(words[3], mesh);
  std::printf("%.4f\n", seconds);
}
