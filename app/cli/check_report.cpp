#include "app/cli/check_report.h"

#include <algorithm>
#include <filesystem>

#include "app/editor/commands/expect.h"
#include "ryosen/base/column_memory.h"
#include "ryosen/base/parallel.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/io/formats.h"

namespace ryosen::cli {

bool CheckReport::has_findings() const {
  return std::any_of(problems.begin(), problems.end(),
                     [](const NamedProblem& p) { return p.problem.row().severity == ProblemSeverity::problem; }) ||
         std::any_of(messages.begin(), messages.end(), [](const Message& m) {
           return m.severity == Severity::warning && !m.code.row().is_about_other_file;
         });
}

std::string_view CheckReport::status() const {
  if (failure) return "error";
  const bool has_warning =
      std::any_of(messages.begin(), messages.end(), [](const Message& m) { return m.severity == Severity::warning; });
  return has_findings() || has_warning ? "warnings" : "ok";
}

namespace {

// How many pairs of a file a report lists. A process may take 64 MiB and 64 times the file; these are the shares for
// pairs, each of which takes up to 64 bytes while the report is written.
std::size_t most_listed_pairs(const std::string& path) {
  constexpr std::size_t share = std::size_t{40} << 20, share_per_byte = 16, bytes_per_pair = 64;
  std::error_code unknown;
  const std::uintmax_t bytes = std::filesystem::file_size(path, unknown);
  return (share + (unknown ? 0 : share_per_byte * static_cast<std::size_t>(bytes))) / bytes_per_pair;
}

}  // namespace

CheckReport check_mesh(MeshFile file, const std::string& path, const CheckScope& scope) {
  CheckReport report;
  report.file = path;
  report.format = file.format ? file.format->id : std::string_view();
  report.messages = std::move(file.messages);
  report.beside = totals_of(file);
  const std::vector<Vertex> on_lines = vertices_on_lines(file, file.mesh.positions.size());
  std::vector<QuarantinedFace> quarantine = std::move(file.mesh.quarantine);
  const std::vector<std::uint32_t> lines = std::move(file.mesh.face_lines);
  const LineRuns vertex_lines = std::move(file.mesh.vertex_lines);
  const Mesh mesh = from_indexed(std::move(file.mesh));
  ProblemSets sets;
  for_each_task(2, threads_for(mesh.halfedge_slots()), [&](unsigned task) {
    if (task == 0) {
      sets = ProblemSets(mesh, 0, on_lines);
      if (scope.figures) report.figures = compute_figures(mesh, sets, quarantine);
      if (scope.kind) report.kind = find_kind(mesh, sets, report.beside.lines);
    } else if (scope.figures) {
      report.hash = hash_text(mesh);
    }
  });
  SelfIntersections intersections;
  if (scope.self_intersections) intersections = find_self_intersections(mesh, scope.most_pairs);
  std::vector<Problem> problems =
      find_problems(mesh, sets, {quarantine, lines, &vertex_lines}, std::move(intersections));
  release(quarantine);
  for (Problem& problem : problems) {
    NamedProblem named{std::move(problem), {}};
    for (const Element& element : named.problem.elements) named.names.add(name_on_points(mesh, element));
    report.problems.push_back(std::move(named));
  }
  return report;
}

CheckReport check_file(const std::string& path, const CheckScope& scope) {
  const Format* taken_for = nullptr;
  Result<MeshFile> file = read_mesh_file(path, &taken_for);
  if (file) {
    CheckScope bounded = scope;
    bounded.most_pairs = most_listed_pairs(path);
    return check_mesh(std::move(file).value(), path, bounded);
  }
  CheckReport report;
  report.file = path;
  report.failure = file.failure();
  if (taken_for) report.format = taken_for->id;
  return report;
}

}  // namespace ryosen::cli
