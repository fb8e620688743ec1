// Simplification against meshoptimizer in one run: times in turn, their ratio and the bar, then how far each result is
// from the input.
//   RYOSEN_DRAGON=FILE.ply.gz bench_simplify [RATIO...]     the dragon, else the bunny; to 0.1 and 0.01 unless told
// Distances are sampled on both surfaces; a face is turned where its normal is 90 degrees or more from that of the
// input nearest to its middle. That counts faces where two sheets of the input lie nearer to each other than the error,
// too, so the same is told of peers.
#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "ryosen/algo/simplify/simplify.h"
#include "ryosen/analysis/figures.h"
#include "ryosen/geometry/trees/bvh.h"
#include "ryosen/indexed/from_indexed.h"
#include "tests/bench/bench_meshes.h"
#include "tests/bench/cost.h"
#include "tests/bench/counted_memory.h"
#include "tests/bench/generated_meshes.h"

namespace ryosen::bench {
namespace {

using Clock = std::chrono::steady_clock;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

struct Soup {
  std::vector<glm::dvec3> places;
  Triangles triangles;

  glm::dvec3 normal(std::size_t i) const {
    const auto& t = triangles[i];
    return glm::cross(places[t[1]] - places[t[0]], places[t[2]] - places[t[0]]);
  }
  glm::dvec3 at(std::size_t i, double u, double v) const {
    const auto& t = triangles[i];
    return places[t[0]] + u * (places[t[1]] - places[t[0]]) + v * (places[t[2]] - places[t[0]]);
  }
};

Soup soup_of(const Mesh& mesh) {
  Soup soup;
  soup.places.assign(mesh.positions().begin(), mesh.positions().end());
  for (std::uint32_t i = 0; i < mesh.face_slots(); ++i) {
    const Face f(i);
    if (!mesh.is_alive(f)) continue;
    const Halfedge h = mesh.halfedge(f);
    soup.triangles.push_back({mesh.from(h).index, mesh.to(h).index, mesh.from(mesh.prev(h)).index});
  }
  return soup;
}

class Nearest {
 public:
  explicit Nearest(const Soup& soup) : soup_(soup) {
    std::vector<Primitive> primitives;
    for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
      const auto& t = soup.triangles[i];
      primitives.push_back(Primitive::triangle(t[0], t[1], t[2], static_cast<std::uint32_t>(i)));
    }
    tree_.build(soup.places, std::move(primitives));
  }
  NearestHit operator()(const glm::dvec3& p) const { return *tree_.nearest(soup_.places, p, 1e300); }

 private:
  const Soup& soup_;
  Bvh tree_;
};

// The mean of the squared distances of places spread evenly over one surface from the other.
double mean_square(const Soup& from, const Nearest& to) {
  constexpr std::size_t samples = 200000;
  std::vector<double> areas;
  double sum = 0;
  for (std::size_t i = 0; i < from.triangles.size(); ++i) areas.push_back(sum += glm::length(from.normal(i)));
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  double squares = 0;
  for (std::size_t k = 0; k < samples; ++k) {
    const double share = (static_cast<double>(k) + unit(random)) / samples * sum;
    const auto i = static_cast<std::size_t>(std::lower_bound(areas.begin(), areas.end(), share) - areas.begin());
    double u = unit(random), v = unit(random);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const double distance = to(from.at(std::min(i, areas.size() - 1), u, v)).distance;
    squares += distance * distance;
  }
  return squares / samples;
}

void print_quality(const char* name, const Soup& input, const Nearest& near_input, const Soup& result) {
  const Box box = box_of(input.places);
  const Nearest near_result(result);
  const double square = 0.5 * (mean_square(input, near_result) + mean_square(result, near_input));
  std::size_t turned = 0;
  for (std::size_t i = 0; i < result.triangles.size(); ++i) {
    const NearestHit hit = near_input(result.at(i, 1.0 / 3, 1.0 / 3));
    turned += !(glm::dot(result.normal(i), input.normal(hit.slot)) > 0);
  }
  std::size_t slots = 0;
  for (const auto& t : result.triangles)
    slots = std::max<std::size_t>(slots, *std::max_element(t.begin(), t.end()) + 1);
  IndexedMesh indexed;
  indexed.positions.assign(result.places.begin(), result.places.begin() + static_cast<std::ptrdiff_t>(slots));
  for (const auto& t : result.triangles) {
    indexed.corners.insert(indexed.corners.end(), t.begin(), t.end());
    indexed.face_offsets.push_back(static_cast<std::uint32_t>(indexed.corners.size()));
  }
  const Figures figures = compute_figures(from_indexed(std::move(indexed)));
  std::printf("  %-14s faces %zu  RMS %.4f %% of the diagonal  non-manifold edges %zu  turned faces %zu\n", name,
              result.triangles.size(), 100 * std::sqrt(square) / glm::length(box.highest - box.lowest),
              static_cast<std::size_t>(figures[ProblemKind::nonmanifold_edge]), turned);
}

struct Timed {
  Soup soup;
  Cost cost;
};

template <class Work>
Timed timed(Work work) {
  std::optional<decltype(work())> done;
  const Cost cost = cost_of([&] { done.emplace(work()); });
  return {(*done)(), cost};
}

Timed run_ours(const Mesh& mesh, std::size_t faces, unsigned effort) {
  return timed([&] {
    Mesh work = mesh;
    Simplifier simplifier(work, {}, {.faces = faces, .effort = effort}, nullptr, &mesh);
    Progress unheard;
    simplifier.run(unheard);
    return [work = std::move(work)] { return soup_of(work); };
  });
}

Timed run_theirs(const Soup& soup, std::size_t faces) {
  std::vector<unsigned> corners;
  std::vector<float> places;
  for (const auto& t : soup.triangles) corners.insert(corners.end(), t.begin(), t.end());
  for (const glm::dvec3& p : soup.places)
    for (int i = 0; i < 3; ++i) places.push_back(static_cast<float>(p[i]));
  return timed([&] {
    std::vector<unsigned> out(corners.size());
    out.resize(meshopt_simplify(out.data(), corners.data(), corners.size(), places.data(), soup.places.size(),
                                3 * sizeof(float), 3 * faces, 1e30f, 0, nullptr));
    return [out = std::move(out), &soup] {
      Soup result{soup.places, {}};
      for (std::size_t i = 0; i < out.size(); i += 3) result.triangles.push_back({out[i], out[i + 1], out[i + 2]});
      return result;
    };
  });
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

// What several turns of both cost, one after the other, so that what else goes on meets both alike.
void print_costs(double ratio, const Costs& ours, const Costs& theirs, std::vector<double> walls,
                 std::vector<double> cpus) {
  constexpr double bar = 2;
  const double wall = median(std::move(walls));
  std::printf(
      "to %g: %.3f s (cpu %.3f), meshoptimizer %.3f s (cpu %.3f), ratio %.2f (least %.2f, cpu %.2f; bar %.0f: %s)\n",
      ratio, 1e-3 * ours.median(), 1e-3 * ours.least_cpu(), 1e-3 * theirs.median(), 1e-3 * theirs.least_cpu(), wall,
      ours.least() / theirs.least(), median(std::move(cpus)), bar, wall <= bar ? "reached" : "MISSED");
}

// Time and memory over growing meshes, to 0.5 %: the largest has twelve million faces.
void print_growth() {
  std::size_t before = 0;
  double seconds_before = 0;
  for (const std::uint32_t side : {200u, 707u, 1414u, 2450u}) {
    Mesh mesh = from_indexed(torus(side, side));
    const std::size_t faces = mesh.live().faces, held = allocated_now();
    reset_allocated_peak();
    Costs costs;
    std::size_t peak = 0;
    for (int i = 0; i < (side < 1000 ? 3 : 1); ++i) costs.add(run_ours(mesh, faces / 200, 1).cost);
    peak = allocated_peak() - held;
    std::printf("growth: %7zu faces in %.4f s, %.0f bytes per face at the peak", faces, 1e-3 * costs.least(),
                static_cast<double>(peak) / static_cast<double>(faces));
    if (before > 0)
      std::printf(", %.2f times for %.2f times the faces", 1e-3 * costs.least() / seconds_before,
                  static_cast<double>(faces) / static_cast<double>(before));
    std::printf("\n");
    before = faces;
    seconds_before = 1e-3 * costs.least();
  }
}

void compare(const Mesh& mesh, const Soup& input, const Nearest& near_input, double ratio) {
  constexpr int turns = 5;
  const auto faces = static_cast<std::size_t>(ratio * mesh.live().faces);
  Costs ours, theirs;
  std::vector<double> walls, cpus;
  Timed our, their;
  for (int i = 0; i < turns; ++i) {
    our = run_ours(mesh, faces, 1);
    their = run_theirs(input, faces);
    ours.add(our.cost);
    theirs.add(their.cost);
    walls.push_back(our.cost.wall / their.cost.wall);
    cpus.push_back(our.cost.cpu / their.cost.cpu);
  }
  print_costs(ratio, ours, theirs, walls, cpus);
  print_quality("Ryosen", input, near_input, our.soup);
  print_quality("meshoptimizer", input, near_input, their.soup);
  for (const unsigned effort : {0u, 2u}) {
    const Timed other = run_ours(mesh, faces, effort);
    std::printf("  effort %u: %.3f s (cpu %.3f)\n", effort, 1e-3 * other.cost.wall, 1e-3 * other.cost.cpu);
    print_quality("Ryosen", input, near_input, other.soup);
  }
}

// The move of a slider by so many collapses, both ways, from several places.
void time_levels(const Mesh& mesh) {
  constexpr std::size_t move = 10000;
  DetailLevels levels(mesh);
  Progress unheard;
  levels.build({}, {.faces = mesh.live().faces / 100}, unheard);
  std::vector<double> times;
  for (std::size_t from = 0; from + move <= levels.last(); from += 5 * move) {
    levels.go_to(from);
    for (const std::size_t to : {from + move, from}) {
      const auto start = Clock::now();
      levels.go_to(to);
      times.push_back(std::chrono::duration<double>(Clock::now() - start).count());
    }
  }
  if (times.empty()) return;
  std::printf("levels: %zu, %.0f bytes per face beside the mesh; %zu at once in %.1f ms, %.1f at most (bar 16)\n",
              levels.last(), static_cast<double>(levels.bytes()) / mesh.live().faces, move, 1e3 * median(times),
              1e3 * *std::max_element(times.begin(), times.end()));
}

}  // namespace
}  // namespace ryosen::bench

int main(int argc, char** argv) {
  using namespace ryosen;
  using namespace ryosen::bench;
  const bool has_dragon = !dragon().positions.empty();
  const Mesh mesh = from_indexed(has_dragon ? dragon() : bunny());
  const Soup input = soup_of(mesh);
  const Nearest near_input(input);
  std::printf("%s, %u faces\n", has_dragon ? "dragon" : "bunny", mesh.live().faces);
  std::vector<double> ratios{0.1, 0.01};
  if (argc > 1) ratios.clear();
  for (int i = 1; i < argc; ++i) ratios.push_back(std::stod(argv[i]));
  for (const double ratio : ratios) compare(mesh, input, near_input, ratio);
  print_growth();
  time_levels(mesh);
}
