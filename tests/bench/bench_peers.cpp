// The kernel against CGAL's Surface_mesh in one run: a table of rates, their ratio, and the ratio to reach.
//   bench_peers [WORD...]   only the rows whose name holds one of the words. RYOSEN_DRAGON=FILE.ply.gz adds the dragon.
// Both sides run in turn, so that a machine that slows down slows both; a ratio is the median of the ratios of turns.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "ryosen/analysis/one_ring_sums.h"
#include "ryosen/base/column_memory.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/prefetch.h"
#include "ryosen/ops/collapse_edge.h"
#include "ryosen/ops/preview/collapsible_edges.h"
#include "ryosen/ops/swap_edge.h"
#include "tests/bench/bench_meshes.h"
#include "tests/bench/counted_memory.h"
#include "tests/bench/generated_meshes.h"
#include "tests/bench/peer_cgal.h"

namespace ryosen::bench {
namespace {

using Clock = std::chrono::steady_clock;
// Runs once and returns how many things were done per microsecond.
using Run = std::function<double()>;

// Keeps a result alive.
template <class T>
void use(const T& value) {
  asm volatile("" : : "g"(&value) : "memory");
}

template <class Work>
double rate(std::size_t count, Work work) {
  const auto start = Clock::now();
  work();
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return 1e-6 * static_cast<double>(count) / seconds;
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

std::vector<std::string> words;

bool is_wanted(const std::string& name) {
  return words.empty() || std::any_of(words.begin(), words.end(),
                                      [&](const std::string& w) { return name.find(w) != std::string::npos; });
}

// One row: the rates of both, in millions per second. A bar of 0 stands for none, a null peer for none.
void compare(const std::string& name, double bar, int turns, const Run& ours, const Run& theirs) {
  if (!is_wanted(name)) return;
  std::vector<double> mine, peer, ratios;
  for (int i = 0; i <= turns; ++i) {
    const double a = ours(), b = theirs ? theirs() : 0;
    if (i == 0 && turns > 1) continue;  // warm up
    mine.push_back(a);
    peer.push_back(b);
    ratios.push_back(theirs ? a / b : 0);
  }
  std::printf("%-44s %9.2f", name.c_str(), median(mine));
  if (!theirs)
    std::printf(" %9s %8s %8s\n", "-", "-", "-");
  else if (bar == 0)
    std::printf(" %9.2f %7.2fx %8s\n", median(peer), median(ratios), "-");
  else
    std::printf(" %9.2f %7.2fx %7.2fx %s\n", median(peer), median(ratios), bar,
                median(ratios) >= bar ? "reached" : "short");
  std::fflush(stdout);
}

// Has the system ready what a build of so many faces takes. A virtual machine may have lent free pages to its host, and
// getting them back, at half a gigabyte a second here, would be all that is measured.
void warm_memory(std::size_t faces) {
  UnwrittenVector<char> block;
  block.resize(200 * faces);
  for (std::size_t i = 0; i < block.size(); i += 4096) block[i] = 1;
  use(block);
}

void compare_build(const std::string& name, double bar, int turns, const IndexedMesh& source) {
  if (source.positions.empty()) return;
  const std::size_t faces = source.face_count();
  compare(
      "build " + name, bar, turns,
      [&] {
        IndexedMesh copy = source;
        Mesh mesh;
        warm_memory(faces);
        return rate(faces, [&] { mesh = from_indexed(std::move(copy)); });
      },
      [&] {
        CgalMesh mesh;
        warm_memory(faces);
        return rate(faces, [&] { mesh = CgalMesh::build(source); });
      });
}

double walk_one_rings(const Mesh& mesh) {
  glm::dvec3 sum(0);
  for (std::uint32_t i = 0; i < mesh.vertex_slots(); ++i)
    for (Vertex neighbour : neighbours(mesh, Vertex(i))) sum += mesh.position(neighbour);
  return sum.x + sum.y + sum.z;
}

template <class Op>
std::size_t count_legal(const Mesh& mesh) {
  std::size_t count = 0;
  for (std::uint32_t e = 0; e < mesh.edge_slots(); ++e) count += Op{halfedge(Edge(e))}.is_legal(mesh);
  return count;
}

template <class Op>
std::size_t do_each(Mesh& mesh, Journal* journal, const std::vector<std::uint32_t>& edges) {
  using Around = Lookahead::Around;
  Lookahead ahead(mesh, std::is_same_v<Op, SwapEdge> ? Around::apexes : Around::ends);
  std::size_t count = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (i + Lookahead::distance < edges.size()) ahead.announce(Edge(edges[i + Lookahead::distance]));
    const Op op{halfedge(Edge(edges[i]))};
    if (!op.is_legal(mesh)) continue;
    Edit edit(mesh, journal);
    op.apply(edit);
    edit.commit();
    ++count;
  }
  return count;
}

void compare_queries(const std::string& name, const Mesh& mesh, const CgalMesh& peer, double ring_bar,
                     double check_bar) {
  constexpr int turns = 7;
  const std::size_t vertices = mesh.vertex_slots(), edges = mesh.edge_slots();
  compare(
      "one-ring sums vertex by vertex " + name, 0, turns,
      [&] { return rate(vertices, [&] { use(walk_one_rings(mesh)); }); },
      [&] { return rate(vertices, [&] { use(peer.walk_one_rings()); }); });
  std::vector<glm::dvec3> sums(vertices);
  const auto all_sums = [&] {
    return rate(vertices, [&] {
      one_ring_sums(mesh, mesh.positions(), sums);
      use(sums);
    });
  };
  compare("one-ring sums " + name, ring_bar, turns, all_sums,
          [&] { return rate(vertices, [&] { use(peer.walk_one_rings()); }); });
  compare("one-ring sums, peer over edges too " + name, 0, turns, all_sums,
          [&] { return rate(vertices, [&] { peer.sum_one_rings_over_edges(sums); }); });
  compare(
      "collapse check edge by edge " + name, 0, turns,
      [&] { return rate(edges, [&] { use(count_legal<CollapseEdge>(mesh)); }); },
      [&] { return rate(edges, [&] { use(peer.count_collapsible()); }); });
  compare(
      "collapse check " + name, check_bar, turns, [&] { return rate(edges, [&] { use(collapsible_edges(mesh)); }); },
      [&] { return rate(edges, [&] { use(peer.count_collapsible()); }); });
  compare(
      "swap check " + name, 0, turns, [&] { return rate(edges, [&] { use(count_legal<SwapEdge>(mesh)); }); },
      [&] { return rate(edges, [&] { use(peer.count_swappable()); }); });
}

// The rate of what was done on a fresh copy, among random edges.
template <class Mesh, class Work>
double rate_on(Mesh copy, Work work) {
  std::size_t done = 0;
  const double per_run = rate(1, [&] { done = work(copy); });
  return per_run * static_cast<double>(done);
}

void compare_edits(const std::string& name, const Mesh& mesh, const CgalMesh& peer) {
  constexpr int turns = 5;
  std::mt19937 random(1);
  std::vector<std::uint32_t> edges(mesh.edge_slots() / 3);
  for (std::uint32_t& e : edges) e = static_cast<std::uint32_t>(random() % mesh.edge_slots());
  const auto ours = [&](auto op, bool with_journal) -> Run {
    using Op = decltype(op);
    return [&mesh, &edges, with_journal] {
      Journal journal;
      return rate_on(mesh, [&](Mesh& m) { return do_each<Op>(m, with_journal ? &journal : nullptr, edges); });
    };
  };
  const Run cgal_swaps = [&] { return rate_on(peer.copy(), [&](CgalMesh& m) { return m.swap_each(edges); }); };
  const Run cgal_collapses = [&] { return rate_on(peer.copy(), [&](CgalMesh& m) { return m.collapse_each(edges); }); };
  const std::string swaps = "random swaps " + name, collapses = "random collapses " + name;
  compare(swaps, 2.7, turns, ours(SwapEdge(), false), cgal_swaps);
  compare(swaps + ", with journal", 0, turns, ours(SwapEdge(), true), cgal_swaps);
  compare(collapses, 2.9, turns, ours(CollapseEdge(), false), cgal_collapses);
  compare(collapses + ", with journal", 1.45, turns, ours(CollapseEdge(), true), cgal_collapses);
  if (!is_wanted("undo") && !is_wanted("redo")) return;
  Mesh edited = mesh;
  Journal journal;
  const std::size_t count = do_each<CollapseEdge>(edited, &journal, edges);
  compare(
      "undo of collapses " + name, 0, turns,
      [&] {
        const double undone = rate(count, [&] {
          while (journal.can_undo()) journal.undo(edited);
        });
        while (journal.can_redo()) journal.redo(edited);
        return undone;
      },
      nullptr);
  compare(
      "redo of collapses " + name, 0, turns,
      [&] {
        while (journal.can_undo()) journal.undo(edited);
        return rate(count, [&] {
          while (journal.can_redo()) journal.redo(edited);
        });
      },
      nullptr);
}

void show_memory(const std::string& name, const IndexedMesh& source) {
  if (source.positions.empty() || !is_wanted("memory " + name)) return;
  IndexedMesh copy = source;
  const auto triangles = static_cast<double>(source.face_count());
  const std::size_t taken = copy.corners.capacity() * sizeof(std::uint32_t) +
                            copy.face_offsets.capacity() * sizeof(std::uint32_t) +
                            copy.positions.capacity() * sizeof(glm::dvec3);
  const std::size_t before = allocated_now() - taken;
  reset_allocated_peak();
  const Mesh mesh = from_indexed(std::move(copy));
  const double peak = static_cast<double>(allocated_peak() - before - taken) / triangles;
  std::printf("%-44s %9.1f bytes per triangle, bar 68\n", ("memory " + name + ", live").c_str(),
              static_cast<double>(mesh.core_bytes()) / triangles);
  std::printf("%-44s %9.1f bytes per triangle beside the arrays it is given, bar 100\n",
              ("memory " + name + ", builder").c_str(), peak);
}

void run_mesh(const std::string& name, const IndexedMesh& source, double build_bar, double ring_bar, double check_bar,
              bool edits) {
  if (source.positions.empty()) {
    std::printf("%s: left out, RYOSEN_DRAGON is not set\n", name.c_str());
    return;
  }
  compare_build(name, build_bar, 9, source);
  show_memory(name, source);
  const Mesh mesh = from_indexed(source);
  const CgalMesh peer = CgalMesh::build(source);
  compare_queries(name, mesh, peer, ring_bar, check_bar);
  if (edits) compare_edits(name, mesh, peer);
}

void run() {
  std::printf("%-44s %9s %9s %8s %8s\n", "millions per second, medians", "ryosen", "CGAL", "ratio", "bar");
  run_mesh("bunny", bunny(), 0, 0, 5.6, false);
  run_mesh("dragon", dragon(), 4.5, 3.4, 7, true);
  if (is_wanted("build 4 M coherent")) compare_build("4 M coherent", 4.4, 5, torus(1000, 2000));
  if (is_wanted("memory 4 M coherent")) show_memory("4 M coherent", torus(1000, 2000));
  if (is_wanted("build 10 M coherent")) compare_build("10 M coherent", 4.4, 3, torus(2000, 2500));
  if (is_wanted("build 4 M shuffled")) compare_build("4 M shuffled", 6.7, 3, shuffled(torus(1000, 2000)));
}

}  // namespace
}  // namespace ryosen::bench

int main(int argc, char** argv) {
  ryosen::bench::words.assign(argv + 1, argv + argc);
  ryosen::bench::run();
}
