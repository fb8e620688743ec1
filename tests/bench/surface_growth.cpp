#include "tests/bench/surface_growth.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "ryosen/algo/algorithm_table.h"
#include "ryosen/analysis/measure/distance.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/ops/all.h"
#include "ryosen/scene/highlights/map_values.h"
#include "tests/bench/counted_memory.h"
#include "tests/bench/generated_meshes.h"

namespace ryosen::bench {

namespace {

struct Work {
  const char* name;
  std::function<void(Mesh&)> run;
};

void run_line(Mesh& mesh, std::string_view line) {
  const std::vector<std::string_view> words = split_words(line);
  const AlgorithmRow& row = *find_algorithm(words[0]);
  const ParameterValues values = *read_values(row.parameters, std::span(words).subspan(1)).values->on(mesh).values;
  Progress unheard;
  Edit edit(mesh, nullptr);
  row.run(edit, {values}, unheard);
  edit.commit();
}

Mesh moved_by_little(const Mesh& mesh) {
  MeshColumns columns = mesh.columns();
  for (glm::dvec3& p : columns.positions) p *= 1.001;
  return Mesh(std::move(columns));
}

std::vector<Work> all_work() {
  const auto line = [](const char* text) { return Work{text, [text](Mesh& mesh) { run_line(mesh, text); }}; };
  // Lengths are about those of the edges: the finer the torus, the shorter.
  const auto remesh = [](Mesh& mesh) {
    const double length = 7 / std::sqrt(double(mesh.live().faces));
    run_line(mesh, "remesh rounds=1 length=" + std::to_string(length));
  };
  return {line("subdivide scheme=loop"),
          line("subdivide scheme=catmull_clark"),
          line("subdivide scheme=sqrt3"),
          line("subdivide scheme=loop limit=on"),
          line("smooth steps=1"),
          line("smooth method=implicit steps=1"),
          {"remesh rounds=1", remesh},
          line("delaunay"),
          line("unite_planar"),
          line("simplify ratio=0.1"),
          {"curvature map", [](Mesh& mesh) { MapValues(mesh, *find_colour_map("mean_curvature")); }},
          {"distance", [](Mesh& mesh) {
             Progress unheard;
             surface_distance(mesh, moved_by_little(mesh), {}, unheard);
           }}};
}

}  // namespace

void print_surface_growth() {
  constexpr std::array<std::uint32_t, 3> rows{160, 320, 640};
  std::printf("\n%-32s %9s %9s %9s %9s %9s\n", "milliseconds of a torus", "51 k", "205 k", "819 k", "exponent",
              "bytes");
  for (const Work& work : all_work()) {
    std::array<double, rows.size()> times{};
    double bytes = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const Mesh source = from_indexed(torus(rows[i], rows[i]));
      for (int turn = 0; turn < 2; ++turn) {  // the better one
        Mesh mesh = source;
        const std::size_t before = allocated_now();
        reset_allocated_peak();
        const auto start = std::chrono::steady_clock::now();
        work.run(mesh);
        const double ms = 1000 * std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        times[i] = turn == 0 ? ms : std::min(times[i], ms);
        bytes = double(allocated_peak() - before) / source.live().faces;
      }
    }
    std::printf("%-32s %9.1f %9.1f %9.1f %9.2f %9.0f\n", work.name, times[0], times[1], times[2],
                std::log(times[2] / times[0]) / std::log(16.0), bytes);
    std::fflush(stdout);
  }
}

}  // namespace ryosen::bench
