#include "tests/bench/peer_hulls.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <cstdio>
#include <vector>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace ryosen::bench {

std::size_t qhull_vertices(std::span<const glm::dvec3> points) {
  qhT state;
  qhT* const qh = &state;
  qh_zero(qh, stderr);
  char options[] = "qhull ";
  auto* const places = const_cast<coordT*>(reinterpret_cast<const coordT*>(points.data()));
  std::FILE* const silent = std::fopen("/dev/null", "w");
  const int code = qh_new_qhull(qh, 3, static_cast<int>(points.size()), places, 0, options, silent, silent);
  const std::size_t vertices = code == 0 ? static_cast<std::size_t>(qh->num_vertices) : 0;
  qh_freeqhull(qh, qh_ALL);
  int left = 0, total = 0;
  qh_memfreeshort(qh, &left, &total);
  std::fclose(silent);
  return vertices;
}

std::size_t cgal_vertices(std::span<const glm::dvec3> points) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_3> places;
  places.reserve(points.size());
  for (const glm::dvec3& p : points) places.emplace_back(p.x, p.y, p.z);
  CGAL::Surface_mesh<Kernel::Point_3> hull;
  CGAL::convex_hull_3(places.begin(), places.end(), hull);
  return hull.number_of_vertices();
}

}  // namespace ryosen::bench
