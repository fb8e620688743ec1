// `ryosen check` as a whole, from the start of the process to its end: one large mesh, its self-intersections, a folder
// of many small files, and the memory for ten million triangles. RYOSEN_DRAGON=FILE.ply.gz adds the dragon. Beside it
// what CGAL takes to read the same files, or to search the same mesh, on one thread.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "ryosen/io/formats.h"
#include "tests/bench/bench_meshes.h"
#include "tests/bench/cost.h"
#include "tests/bench/generated_meshes.h"
#include "tests/bench/peer_cgal.h"
#include "tests/bench/peer_cgal_intersections.h"
#include "tests/bench/process.h"

namespace ryosen::bench {
namespace {

namespace fs = std::filesystem;

ProcessCost run_check(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"check", "--json"});
  ProcessCost cost = run_program(std::move(arguments));
  if (WIFEXITED(cost.status)) return cost;
  std::fprintf(stderr, "a check ended by a signal\n");
  std::exit(70);
}

void write(const IndexedMesh& mesh, const fs::path& path, std::string_view id) {
  MeshFile file;
  file.mesh = mesh;
  if (!write_mesh_file(path, file, *find_target(id))) std::exit(5);
}

Costs repeat(int turns, const std::function<Cost()>& work) {
  Costs costs;
  work();  // warm up
  for (int i = 0; i < turns; ++i) costs.add(work());
  return costs;
}

void check_one(const std::string& name, const IndexedMesh& mesh, const fs::path& folder, double bar_ms,
               double bar_intersections_ms) {
  const fs::path path = folder / (name + ".ply");
  write(in_floats(mesh), path, "ply-little");
  const Costs whole = repeat(9, [&] { return run_check({path}).cost; });
  const Costs reading = repeat(3, [&] { return cost_of([&] { CgalMesh::read(path); }); });
  print_row(name + ", check; CGAL reads", whole, reading, bar_ms);
  const Costs searched = repeat(3, [&] { return run_check({"--self-intersections", path}).cost; });
  const auto search = cgal_intersections(mesh);
  Costs theirs;
  theirs.add(cost_of(search));
  print_row(name + ", self-intersections", searched, theirs, bar_intersections_ms);
  fs::remove(path);
}

void check_folder(const fs::path& folder) {
  constexpr std::uint32_t files = 10000, files_per_second = 1500;
  const fs::path many = folder / "many";
  fs::create_directory(many);
  const std::pair<const char*, const char*> kinds[] = {
      {"obj", ".obj"}, {"ply-little", ".ply"}, {"stl-binary", ".stl"}, {"off", ".off"}, {"ply-ascii", ".ply"}};
  std::vector<fs::path> paths;
  for (std::uint32_t i = 0; i < files; ++i) {
    const auto& [id, extension] = kinds[i % std::size(kinds)];
    paths.push_back(many / (std::to_string(i) + extension));
    write(torus(4 + i % 13, 3 + i % 11), paths.back(), id);  // 24 to 416 triangles
  }
  const Costs ours = repeat(3, [&] { return run_check({"--jobs", "2", many}).cost; });
  Costs theirs;
  theirs.add(cost_of([&] {
    for (const fs::path& path : paths) CgalMesh::read(path);
  }));
  print_row("10,000 files; CGAL reads", ours, theirs, 1e3 * files / files_per_second);
  std::printf("  %.0f files/s\n", 1e3 * files / ours.least());
}

void measure_memory(const fs::path& folder) {
  constexpr std::uint32_t rows = 2500, columns = 2000;
  constexpr double triangles = 2.0 * rows * columns, bar = 120;
  const fs::path path = folder / "large.ply";
  run_process([&] {
    write(in_floats(torus(rows, columns)), path, "ply-little");
    _exit(0);
  });
  const ProcessCost cost = run_check({path});
  fs::remove(path);
  const double bytes = cost.peak_bytes / triangles;
  std::printf("%.0f triangles, check: %.1f bytes per triangle at the peak, bar %.0f %s; %.0f ms, cpu %.0f\n", triangles,
              bytes, bar, bytes <= bar ? "reached" : "short", cost.cost.wall, cost.cost.cpu);
}

void run() {
  const fs::path folder = fs::temp_directory_path() / ("ryosen_bench_check_" + std::to_string(getpid()));
  fs::create_directory(folder);
  measure_memory(folder);
  print_head("check, ms");
  check_one("bunny", bunny(), folder, 0, 0);
  check_folder(folder);
  if (!dragon().positions.empty()) check_one("dragon", dragon(), folder, 250, 3000);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace ryosen::bench

int main() { ryosen::bench::run(); }
