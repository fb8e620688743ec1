#include "app/cli/check_report.h"

#include <algorithm>

#include "app/editor/expect.h"
#include "core/base/parallel.h"
#include "core/base/release.h"
#include "core/indexed/from_indexed.h"
#include "core/io/formats.h"

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

// Limit on listed pairs; longer reports are useless.
constexpr std::size_t most_listed_pairs = 1000000;

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
  if (scope.self_intersections) intersections = find_self_intersections(mesh, most_listed_pairs);
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
  if (file) return check_mesh(std::move(file).value(), path, scope);
  CheckReport report;
  report.file = path;
  report.failure = file.failure();
  if (taken_for) report.format = taken_for->id;
  return report;
}

}  // namespace ryosen::cli
