#include "app/cli/check_report.h"

#include <algorithm>

#include "app/cli/contract/check.h"
#include "app/cli/contract/record.h"
#include "app/editor/expect.h"
#include "core/base/parallel.h"
#include "core/base/release.h"
#include "core/indexed/from_indexed.h"
#include "core/io/formats.h"

namespace ryosen::cli {

namespace {

Json place(const std::optional<glm::dvec3>& where) { return where ? to_json(*where) : Json(); }

Json bounds(const Figures& f) {
  return f.bounds ? Json::array({to_json((*f.bounds)[0]), to_json((*f.bounds)[1])}) : Json();
}

void add_figures(const Figures& f, const ElementTotals& beside, Record<check_shape>& json) {
  json["vertices"] = f.vertices;
  json["corners"] = f.corners;
  json["faces"] = f.faces;
  if (beside.lines > 0) json["lines"] = beside.lines;
  if (beside.points > 0) json["points"] = beside.points;
  json["edges"] = f.edges;
  json["triangles"] = f.triangles;
  json["quads"] = f.quads;
  json["polygons"] = f.polygons;
  json["quarantined"] = f.quarantined;
  json["rings"] = f.rings;
  json["boundary_edges"] = f.boundary_edges;
  json["boundary_loops"] = f.boundary_loops;
  json["nonmanifold_edges"] = f.nonmanifold_edges;
  json["max_edge_faces"] = f.max_edge_faces;
  json["nonmanifold_vertices"] = f.nonmanifold_vertices;
  json["bowtie_vertices"] = f.bowtie_vertices;
  json["misoriented_edges"] = f.misoriented_edges;
  json["degenerate_repeat"] = f.degenerate_repeat;
  json["degenerate_area"] = f.degenerate_area;
  json["duplicate_faces"] = f.duplicate_faces;
  json["hanging_pairs"] = f.hanging_pairs;
  json["isolated_vertices"] = f.isolated_vertices;
  json["nonfinite_vertices"] = f.nonfinite_vertices;
  json["components"] = f.components;
  json["euler_characteristic"] = f.euler_characteristic;
  json["genus"] = f.genus ? Json(*f.genus) : Json();
  json["manifold"] = f.manifold;
  json["closed"] = f.closed;
  json["orientable"] = f.orientable;
  json["bounds"] = bounds(f);
  json["area"] = f.area;
  json["volume"] = f.volume ? Json(*f.volume) : Json();
}

}  // namespace

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

CheckReport check_mesh(MeshFile file, const std::string& path, bool with_self_intersections) {
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
      report.figures = compute_figures(mesh, sets, quarantine);
      report.kind = find_kind(mesh, sets, report.beside.lines);
    } else {
      report.hash = hash_text(mesh);
    }
  });
  SelfIntersections intersections;
  if (with_self_intersections) intersections = find_self_intersections(mesh, most_listed_pairs);
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

CheckReport check_file(const std::string& path, bool with_self_intersections) {
  const Format* taken_for = nullptr;
  Result<MeshFile> file = read_mesh_file(path, &taken_for);
  if (file) return check_mesh(std::move(file).value(), path, with_self_intersections);
  CheckReport report;
  report.file = path;
  report.failure = file.failure();
  if (taken_for) report.format = taken_for->id;
  return report;
}

namespace {

// Without the names; an empty array is the placeholder.
Json without_names(const Problem& problem) {
  Record<problem_shape> json;
  json["kind"] = problem.row().id;
  json["severity"] = problem.row().severity == ProblemSeverity::problem ? "problem" : "info";
  json["count"] = problem.count();
  json["elements"] = Json::array();
  if (problem.row().is_on_request) {
    json["pairs"] = Json::array();
    const auto name = [](Face f) { return "f" + std::to_string(f.index); };
    for (const FacePair& pair : problem.intersections.pairs)
      json["pairs"].push_back({name(pair.first), name(pair.second)});
    json["complete"] = problem.intersections.is_all;
  }
  json["where"] = place(problem.where);
  json["line"] = problem.line ? Json(problem.line) : Json();
  json["en"] = problem.text.en;
  json["ja"] = problem.text.ja;
  return std::move(json).json();
}

}  // namespace

Json to_json(const NamedProblem& named) {
  Json json = without_names(named.problem);
  named.names.for_each(named.problem.count(), [&](std::string_view name) { json["elements"].push_back(name); });
  return json;
}

std::string json_line_of(const CheckReport& report) {
  if (report.failure) return line_of(error_object(report.failure->message, report.file, report.format));
  Record<check_shape> json;
  json["file"] = report.file;
  json["format"] = report.format;
  json["status"] = report.status();
  add_figures(report.figures, report.beside, json);
  json["kind"] = row_of(report.kind.kind).id;
  json["kind_reason"] = {{"en", report.kind.reason.en}, {"ja", report.kind.reason.ja}};
  json["hash"] = report.hash;
  json["problems"] = Json::array();
  for (const NamedProblem& problem : report.problems) json["problems"].push_back(without_names(problem.problem));
  json["messages"] = to_json(report.messages);
  const std::string line = line_of(json);
  // Cannot occur in file contents, since quotes inside strings are escaped.
  constexpr std::string_view place = "\"elements\":[]";
  std::string out;
  std::size_t bytes = line.size(), done = 0;
  for (const NamedProblem& problem : report.problems) bytes += problem.names.bytes() + 2 * problem.problem.count();
  out.reserve(bytes);
  for (const NamedProblem& problem : report.problems) {
    const std::size_t at = line.find(place, done) + place.size() - 1;
    out.append(line, done, at - done);
    problem.names.for_each(problem.problem.count(), [&](std::string_view name) {
      if (out.back() != '[') out += ',';
      out += '"';
      out += name;
      out += '"';
    });
    done = at;
  }
  return out.append(line, done);
}

}  // namespace ryosen::cli
