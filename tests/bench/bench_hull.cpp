// The convex hull against Qhull and CGAL in one run, its growth, and its bytes per point.
//   bench_hull [growth] [WORD...]   growth: only that; else only the rows whose name holds one of the words.
// RYOSEN_DRAGON=FILE.ply.gz adds the vertices of the dragon. All sides run in turn; a ratio is
// that of the least processor times, ours of all threads, so that a busy machine does not decide.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

#include "ryosen/hull/convex_hull.h"
#include "tests/bench/bench_meshes.h"
#include "tests/bench/cost.h"
#include "tests/bench/counted_memory.h"
#include "tests/bench/peer_hulls.h"

namespace ryosen::bench {
namespace {

enum class Body { ball, sphere };

std::vector<glm::dvec3> random_points(std::size_t count, Body body) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform;
  std::vector<glm::dvec3> points;
  points.reserve(count);
  while (points.size() < count) {
    const glm::dvec3 p(normal(random), normal(random), normal(random));
    const double size = std::sqrt(p.x * p.x + p.y * p.y + p.z * p.z);
    points.push_back(p * ((body == Body::ball ? std::cbrt(uniform(random)) : 1.0) / size));
  }
  return points;
}

std::vector<std::string> words;

bool is_wanted(const std::string& name) {
  if (words.empty()) return true;
  for (const std::string& word : words)
    if (name.find(word) != std::string::npos) return true;
  return false;
}

void compare(const std::string& name, const std::vector<glm::dvec3>& points, int turns, double qhull_bar,
             double cgal_bar) {
  if (points.empty() || !is_wanted(name)) return;
  Costs ours, qhull, cgal;
  std::size_t vertices = 0, of_qhull = 0, of_cgal = 0;
  for (int i = 0; i < turns; ++i) {
    ours.add(cost_of([&] { vertices = convex_hull(points).vertices.size(); }));
    qhull.add(cost_of([&] { of_qhull = qhull_vertices(points); }));
    cgal.add(cost_of([&] { of_cgal = cgal_vertices(points); }));
  }
  const double to_qhull = qhull.least_cpu() / ours.least_cpu(), to_cgal = cgal.least_cpu() / ours.least_cpu();
  std::printf("%-12s %9.1f %9.1f %9.1f %9.1f %6.1fx (%.0fx %s) %6.1fx (%.0fx %s)  vertices %zu %zu %zu\n", name.c_str(),
              ours.least(), ours.least_cpu(), qhull.least_cpu(), cgal.least_cpu(), to_qhull, qhull_bar,
              to_qhull >= qhull_bar ? "reached" : "short", to_cgal, cgal_bar, to_cgal >= cgal_bar ? "reached" : "short",
              vertices, of_qhull, of_cgal);
  std::fflush(stdout);
}

void grow(const std::string& name, Body body) {
  for (std::size_t count = 1000; count <= 10'000'000; count *= 10) {
    const std::vector<glm::dvec3> points = random_points(count, body);
    const std::size_t before = allocated_now();
    reset_allocated_peak();
    ConvexHull hull;
    const Cost cost = cost_of([&] { hull = convex_hull(points); });
    std::printf("%-8s %9zu points %9.1f ms %9.1f ms cpu %7.1f ns a point %7.1f bytes a point %9zu facets\n",
                name.c_str(), count, cost.wall, cost.cpu, 1e6 * cost.cpu / static_cast<double>(count),
                static_cast<double>(allocated_peak() - before) / static_cast<double>(count), hull.facet_count());
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace ryosen::bench

int main(int count, char** arguments) {
  using namespace ryosen::bench;
  words.assign(arguments + 1, arguments + count);
  if (!words.empty() && words[0] == "growth") {
    grow("ball", Body::ball);
    grow("sphere", Body::sphere);
    return 0;
  }
  std::printf("%-12s %9s %9s %9s %9s  ratios to Qhull, CGAL (ms)\n", "", "wall", "cpu", "Qhull", "CGAL");
  compare("ball 1M", random_points(1'000'000, Body::ball), 5, 3, 4);
  compare("dragon", dragon().positions, 5, 3, 4);
  compare("sphere 1M", random_points(1'000'000, Body::sphere), 1, 3, 4);
  return 0;
}
