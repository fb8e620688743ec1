// Building, judging and editing, without a picture. RYOSEN_DRAGON=FILE.ply.gz adds the dragon.
#include <benchmark/benchmark.h>

#include <chrono>
#include <random>

#include "ryosen/analysis/self_intersections.h"
#include "ryosen/geometry/triangulate.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/ops/all.h"
#include "tests/bench/bench_meshes.h"
#include "tests/unit/core/geometry/polygon_shapes.h"

namespace ryosen::bench {
namespace {

using Source = const IndexedMesh& (*)();
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

void build(benchmark::State& state, Source source) {
  if (source().positions.empty()) return state.SkipWithError("RYOSEN_DRAGON is not set");
  Mesh mesh;
  for (auto _ : state) {
    IndexedMesh copy = source();
    const auto start = Clock::now();
    mesh = from_indexed(std::move(copy));
    state.SetIterationTime(seconds_since(start));
  }
  state.counters["Mfaces/s"] =
      benchmark::Counter(1e-6 * mesh.live().faces, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["bytes/triangle"] = static_cast<double>(mesh.core_bytes()) / mesh.live().faces;
}

// A star of so many corners, or a square frame around so many square holes.
void triangulate_star(benchmark::State& state) {
  const test_shapes::Polygon star = test_shapes::star(static_cast<std::size_t>(state.range(0)), 1);
  std::vector<CornerTriangle> triangles;
  for (auto _ : state) triangulate(star, triangles);
  state.counters["triangles"] = static_cast<double>(triangles.size());
}

void triangulate_holes(benchmark::State& state) {
  const auto side = static_cast<int>(state.range(0));
  std::vector<test_shapes::Polygon> loops;
  const double size = 3.0 * side;
  loops.push_back({{0, 0, 0}, {size, 0, 0}, {size, size, 0}, {0, size, 0}});
  for (int i = 0; i < side; ++i)
    for (int k = 0; k < side; ++k) {
      const double x = 3.0 * i + 1, y = 3.0 * k + 1;
      loops.push_back({{x, y, 0}, {x, y + 1, 0}, {x + 1, y + 1, 0}, {x + 1, y, 0}});
    }
  const std::vector<std::span<const glm::dvec3>> spans(loops.begin(), loops.end());
  std::vector<CornerTriangle> triangles;
  for (auto _ : state) triangulate_loops(spans, triangles);
  state.counters["triangles"] = static_cast<double>(triangles.size());
}

// Random edges, the same every time.
std::vector<Halfedge> random_halfedges(const Mesh& mesh, std::size_t count) {
  std::mt19937 random(1);
  std::vector<Halfedge> halfedges;
  for (std::size_t i = 0; i < count; ++i) halfedges.emplace_back(random() % mesh.halfedge_slots());
  return halfedges;
}

template <class Op>
void judge(benchmark::State& state, Source source) {
  if (source().positions.empty()) return state.SkipWithError("RYOSEN_DRAGON is not set");
  const Mesh mesh = from_indexed(source());
  const std::vector<Halfedge> halfedges = random_halfedges(mesh, 100000);
  std::size_t i = 0, legal = 0;
  for (auto _ : state) {
    legal += Op{halfedges[i]}.check(mesh).legal();
    i = (i + 1) % halfedges.size();
  }
  benchmark::DoNotOptimize(legal);
  state.SetItemsProcessed(state.iterations());
}

// Random legal operators, committed with the journal; taken back outside the measured time.
template <class Op>
void edit_with_journal(benchmark::State& state, Source source) {
  if (source().positions.empty()) return state.SkipWithError("RYOSEN_DRAGON is not set");
  Mesh mesh = from_indexed(source());
  const std::vector<Halfedge> halfedges = random_halfedges(mesh, 20000);
  std::size_t done = 0;
  double bytes = 0;
  for (auto _ : state) {
    Journal journal;
    double seconds = 0;
    std::size_t count = 0;
    for (Halfedge h : halfedges) {
      const Op op{h};
      if (!mesh.is_alive(h) || !op.check(mesh).legal()) continue;
      const auto start = Clock::now();
      Edit edit(mesh, &journal);
      op.apply(edit);
      edit.commit();
      seconds += seconds_since(start);
      if (++count == 2000) break;
    }
    bytes = static_cast<double>(journal.bytes()) / static_cast<double>(count);
    while (journal.can_undo()) journal.undo(mesh);
    state.SetIterationTime(seconds / static_cast<double>(count));
    ++done;
  }
  state.counters["bytes/edit"] = bytes;
}

void undo(benchmark::State& state, Source source) {
  if (source().positions.empty()) return state.SkipWithError("RYOSEN_DRAGON is not set");
  Mesh mesh = from_indexed(source());
  Journal journal;
  for (Halfedge h : random_halfedges(mesh, 5000)) {
    const CollapseEdge op{h};
    if (!mesh.is_alive(h) || !op.check(mesh).legal()) continue;
    Edit edit(mesh, &journal);
    op.apply(edit);
    edit.commit();
  }
  for (auto _ : state) {
    const auto start = Clock::now();
    while (journal.can_undo()) journal.undo(mesh);
    const double seconds = seconds_since(start);
    while (journal.can_redo()) journal.redo(mesh);
    state.SetIterationTime(seconds / static_cast<double>(journal.size()));
  }
}

void self_intersections(benchmark::State& state, Source source) {
  if (source().positions.empty()) return state.SkipWithError("RYOSEN_DRAGON is not set");
  const Mesh mesh = from_indexed(source());
  std::size_t pairs = 0;
  for (auto _ : state) pairs = find_self_intersections(mesh).pairs.size();
  state.counters["pairs"] = static_cast<double>(pairs);
}

void register_all(const std::string& mesh, Source source) {
  const auto add = [&](const std::string& name, void (*run)(benchmark::State&, Source)) {
    return benchmark::RegisterBenchmark((name + "/" + mesh).c_str(), run, source);
  };
  constexpr auto ms = benchmark::kMillisecond;
  constexpr auto us = benchmark::kMicrosecond;
  add("build", build)->UseManualTime()->Unit(ms);
  add("check collapse", judge<CollapseEdge>);
  add("check swap", judge<SwapEdge>);
  add("collapse with journal", edit_with_journal<CollapseEdge>)->UseManualTime()->Unit(us)->Iterations(20);
  add("swap with journal", edit_with_journal<SwapEdge>)->UseManualTime()->Unit(us)->Iterations(20);
  add("split with journal", edit_with_journal<SplitEdge>)->UseManualTime()->Unit(us)->Iterations(20);
  add("self-intersections", self_intersections)->UseRealTime()->Unit(ms);
  add("undo collapse", undo)->UseManualTime()->Unit(us)->Iterations(20);
}

void register_triangulation() {
  constexpr auto ms = benchmark::kMillisecond;
  benchmark::RegisterBenchmark("triangulate star of corners", triangulate_star)->Arg(20000)->Arg(200000)->Unit(ms);
  // 70 x 70 holes and 223 x 223 holes: 19,604 and 198,920 corners.
  benchmark::RegisterBenchmark("triangulate holes, a side", triangulate_holes)->Arg(70)->Arg(223)->Unit(ms);
}

}  // namespace
}  // namespace ryosen::bench

int main(int argc, char** argv) {
  ryosen::bench::register_all("bunny", ryosen::bench::bunny);
  ryosen::bench::register_all("dragon", ryosen::bench::dragon);
  ryosen::bench::register_triangulation();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
