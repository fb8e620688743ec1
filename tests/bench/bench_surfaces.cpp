// Subdivision and remeshing against CGAL's in one run: milliseconds, their ratio, and the ratio to reach.
//   bench_surfaces [WORD...]   only the rows whose name holds one of the words, "growth" for how all of it grows
//                              with the faces. RYOSEN_DRAGON=FILE.ply.gz adds the dragon.
// Both sides run in turn; a ratio is the median of the ratios of turns.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <glm/geometric.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ryosen/algo/remesh/remesh.h"
#include "ryosen/algo/smooth/smooth.h"
#include "ryosen/algo/subdivide/subdivide.h"
#include "ryosen/analysis/measure/distance.h"
#include "ryosen/analysis/self_intersections.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/mesh/circulate.h"
#include "tests/bench/bench_meshes.h"
#include "tests/bench/peer_cgal_surfaces.h"
#include "tests/bench/surface_growth.h"

namespace ryosen::bench {
namespace {

using Clock = std::chrono::steady_clock;
using Run = std::function<double()>;  // milliseconds

std::vector<std::string> wanted_words;

template <class Work>
double milliseconds(const Work& work) {
  const auto start = Clock::now();
  work();
  return 1000 * std::chrono::duration<double>(Clock::now() - start).count();
}

double median_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

bool is_wanted(const std::string& name) {
  return wanted_words.empty() || std::any_of(wanted_words.begin(), wanted_words.end(),
                                             [&](const auto& w) { return name.find(w) != std::string::npos; });
}

void compare(const std::string& name, int turns, const Run& ours, const Run& theirs) {
  if (!is_wanted(name)) return;
  std::vector<double> mine, peer, ratios;
  for (int i = 0; i <= turns; ++i) {
    const double a = ours(), b = theirs();
    if (i == 0 && turns > 1) continue;  // warm up
    mine.push_back(a);
    peer.push_back(b);
    ratios.push_back(b / a);
  }
  constexpr double bar = 3;
  std::printf("%-32s %9.1f %9.1f %7.2fx %7.2fx %s\n", name.c_str(), median_of(mine), median_of(peer), median_of(ratios),
              bar, median_of(ratios) >= bar ? "reached" : "short");
  std::fflush(stdout);
}

void compare_steps(const std::string& name, const IndexedMesh& source, int turns) {
  if (source.positions.empty()) return;
  const Mesh mesh = from_indexed(source);
  const SurfacesPeer peer(source);
  for (const subdivide::Scheme scheme :
       {subdivide::Scheme::loop, subdivide::Scheme::catmull_clark, subdivide::Scheme::sqrt3}) {
    const char* const title = scheme == subdivide::Scheme::loop            ? "Loop step "
                              : scheme == subdivide::Scheme::catmull_clark ? "Catmull-Clark step "
                                                                           : "sqrt(3) step ";
    compare(
        title + name, turns,
        [&] {
          return milliseconds([&] {
            Progress unheard;
            const subdivide::Subdivided made = subdivide::subdivided(mesh, {.scheme = scheme}, unheard);
            if (made.fault) std::printf("%s\n", made.fault->en.c_str());
          });
        },
        [&] { return peer.milliseconds_of_step(title[0]); });
  }
}

double mean_length(const Mesh& mesh) {
  double sum = 0;
  for (std::uint32_t e = 0; e < mesh.edge_slots(); ++e) {
    const auto [a, b] = ends(mesh, Edge(e));
    sum += glm::distance(mesh.position(a), mesh.position(b));
  }
  return sum / mesh.edge_slots();
}

// Lengths in shares of the wanted one, angles in degrees; how far from the input, and how many pairs of faces meet.
void print_quality(const char* who, const Mesh& made, const Mesh& source, double length) {
  const SurfaceQuality q = quality_of(made, length);
  Progress unheard;
  const auto distance = surface_distance(source, made, {.gap = 0.01}, unheard);
  std::printf("  %-8s %8zu %7.3f %7.3f %7.1f %7.1f %6.2f%% %6.1f%% %6.1f%% %8.4f %8.4f %6zu\n", who, q.faces,
              q.mean_length, q.spread, q.smallest_angle_deg, q.mean_angle_deg, 100 * q.narrow, 100 * q.valence_six,
              100 * q.valence_near_six, 100 * distance->rms / distance->diagonal,
              100 * distance->hausdorff / distance->diagonal, find_self_intersections(made).count);
}

void compare_remeshing(const std::string& name, const IndexedMesh& source, double lengths, int turns, unsigned rounds) {
  const Mesh mesh = from_indexed(source);
  const SurfacesPeer peer(source);
  const double length = lengths * mean_length(mesh);
  MeshColumns ours;
  IndexedMesh theirs;
  char title[64];
  std::snprintf(title, sizeof title, "remesh %s %gx, rounds %u", name.c_str(), lengths, rounds);
  compare(
      title, turns,
      [&] {
        return milliseconds([&] {
          Progress unheard;
          ours =
              remesh::remeshed(mesh, {.length = length, .rounds = rounds, .feature_angle_rad = 3.2}, unheard).columns;
        });
      },
      [&] { return peer.milliseconds_of_remeshing(length, rounds, theirs); });
  if (ours.positions.empty()) return;
  std::printf("  %-8s %8s %7s %7s %7s %7s %7s %7s %7s %8s %8s %6s\n", "", "faces", "length", "spread", "angle", "mean",
              "below30", "six", "5 to 7", "rms %", "max %", "cross");
  print_quality("ryosen", Mesh(std::move(ours)), mesh, length);
  print_quality("CGAL", from_indexed(theirs), mesh, length);
}

// Of the dragon from itself after two steps of smoothing.
void compare_distance() {
  const std::string name = "distance of two dragons";
  if (dragon().positions.empty() || !is_wanted(name)) return;
  const Mesh mesh = from_indexed(dragon());
  Progress unheard;
  MeshColumns columns = mesh.columns();
  const smooth::Smoothed made =
      smooth::smoothed(mesh, {.steps = 2}, std::vector<double>(mesh.vertex_slots(), 1), unheard);
  columns.positions.assign(made.places.begin(), made.places.end());
  const Mesh other(std::move(columns));
  std::vector<double> times;
  std::optional<SurfaceDistance> found;
  for (int turn = 0; turn < 3; ++turn)
    times.push_back(milliseconds([&] { found = surface_distance(mesh, other, {}, unheard); }));
  constexpr double bar = 2000;
  std::printf("%-32s %9.1f %26s %s  (rms %.4f %%, largest %.4f %% of the diagonal)\n", name.c_str(), median_of(times),
              "2000 ms", median_of(times) < bar ? "reached" : "short", 100 * found->rms / found->diagonal,
              100 * found->hausdorff / found->diagonal);
}

}  // namespace
}  // namespace ryosen::bench

int main(int argc, char** argv) {
  using namespace ryosen::bench;
  wanted_words.assign(argv + 1, argv + argc);
  std::printf("%-32s %9s %9s %8s %8s\n", "milliseconds, medians", "ryosen", "CGAL", "ratio", "bar");
  compare_steps("bunny", bunny(), 5);
  compare_steps("dragon", dragon(), 5);
  compare_remeshing("bunny", bunny(), 1, 3, 1);
  compare_remeshing("bunny", bunny(), 1, 3, 5);
  compare_remeshing("bunny", bunny(), 2, 3, 5);
  compare_remeshing("bunny", bunny(), 5, 3, 5);
  compare_distance();
  if (wanted_words.empty() || wanted_words.front() == "growth") print_surface_growth();
}
