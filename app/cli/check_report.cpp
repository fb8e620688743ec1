#include "app/cli/check_report.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "app/cli/columns.h"
#include "app/cli/console.h"
#include "app/cli/contract/check.h"
#include "app/editor/commands/expect.h"
#include "ryosen/analysis/boundary_loops.h"
#include "ryosen/analysis/figures.h"
#include "ryosen/base/column_memory.h"
#include "ryosen/base/parallel.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/io/formats.h"
#include "ryosen/ops/op.h"

namespace ryosen::cli {

namespace {

// How many pairs of a file a report lists. A process may take 64 MiB and 64 times the file; these are the shares for
// pairs, each of which takes up to 64 bytes while the report is written.
std::size_t most_listed_pairs(const std::string& path) {
  constexpr std::size_t share = std::size_t{40} << 20, share_per_byte = 16, bytes_per_pair = 64;
  std::error_code unknown;
  const std::uintmax_t bytes = std::filesystem::file_size(path, unknown);
  return (share + (unknown ? 0 : share_per_byte * static_cast<std::size_t>(bytes))) / bytes_per_pair;
}

constexpr std::size_t names_shown = 8;

std::string spaces(std::size_t wanted, std::size_t used) { return std::string(wanted > used ? wanted - used : 1, ' '); }

std::string number(std::uint64_t n) { return std::to_string(n); }

std::string place(const glm::dvec3& p) {
  return "(" + short_number(p.x) + ", " + short_number(p.y) + ", " + short_number(p.z) + ")";
}

std::string value_text(const Json& value, const Console& console) {
  if (value.is_boolean())
    return std::string(value == true ? console.text("yes", "はい") : console.text("no", "いいえ"));
  if (value.is_number_float()) return short_number(value);
  return value.is_null() ? "-" : value.dump();
}

// Lines of three figures, at places that are the same in the reports of all files.
std::string table_text(const CheckReport& report, const Console& console) {
  std::map<int, std::string> lines;  // by the number of the first cell
  std::set<int> shown;
  std::vector<CheckRow> rows = check_rows();
  std::sort(rows.begin(), rows.end(), [](const CheckRow& a, const CheckRow& b) { return a.value.cell < b.value.cell; });
  for (const CheckRow& row : rows) {
    if (row.value.cell < 0) continue;
    const Json value = row.print(report);
    if (!is_absent(row, value)) shown.insert(row.value.cell / 3);
    // A number beside boundary edges that close to no loop would be read as that of all.
    const bool is_no_count = row.key.id == "boundary_loops" && report.figures.open_boundary;
    const std::string label(console.text(row.value.en, row.value.ja)),
        text = value_text(is_no_count ? Json() : value, console);
    lines[row.value.cell / 3] += "  " + label + spaces(20, display_width(label) + display_width(text)) + text + "  ";
  }
  std::string all;
  for (auto& [number, line] : lines) {
    line.erase(line.find_last_not_of(' ') + 1);
    if (shown.contains(number)) all += line + "\n";
  }
  return all;
}

std::string figures_text(const CheckReport& report, const Console& console) {
  const Figures& f = report.figures;
  std::string text = table_text(report, console);
  if (f.open_boundary)
    text += "  " + std::string(console.text("boundary ", "境界 ")) + std::string(console.text(no_loop_count)) + "\n";
  if (const auto name = surface_name(f))
    text += "  " + std::string(console.text("surface ", "曲面 ")) + std::string(console.text(*name)) + "\n";
  if (f.bounds)
    text += "  " + std::string(console.text("bounds ", "範囲 ")) + place((*f.bounds)[0]) + " .. " +
            place((*f.bounds)[1]) + "\n";
  return text;
}

NameList names_of_pairs(const Problem& problem, std::size_t most) {
  NameList names;
  const std::vector<FacePair>& pairs = problem.intersections.pairs;
  for (std::size_t i = 0; i < std::min(most, pairs.size()); ++i)
    names.add("f" + number(pairs[i].first.index) + " x f" + number(pairs[i].second.index));
  return names;
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

std::string to_text(const NamedProblem& named, const Console& console) {
  const Problem& problem = named.problem;
  const bool is_info = problem.row().severity == ProblemSeverity::info;
  std::string text = "  " + std::string(is_info ? console.text("info", "情報") : console.text("PROBLEM", "問題")) +
                     " " + std::string(problem.row().id) + " x" + number(problem.count()) + ": " +
                     console.text(problem.text) + "\n    ";
  const bool has_pairs = !problem.intersections.pairs.empty();
  const std::size_t count = has_pairs ? problem.intersections.pairs.size() : problem.count();
  const std::size_t shown = console.verbose ? count : std::min(count, names_shown);
  const NameList pairs = names_of_pairs(problem, shown);
  std::string_view separator;
  (has_pairs ? pairs : named.names).for_each(shown, [&](std::string_view name) {
    text += separator;
    text += name;
    separator = ", ";
  });
  if (shown < count) {
    const std::string rest = number(count - shown);
    text += console.text(", and " + rest + " more (-v names all)", "、ほか " + rest + " 個（-v ですべて表示）");
  }
  if (problem.where) text += std::string(console.text("; first at ", "；最初の位置 ")) + place(*problem.where);
  if (problem.line) text += std::string(console.text(", line ", "、行 ")) + number(problem.line);
  const std::string_view by_hand = console.text(problem.row().by_hand_en, problem.row().by_hand_ja);
  if (!is_info && !by_hand.empty()) text += "\n    " + std::string(by_hand);
  return text + "\n";
}

std::string to_text(const CheckReport& report, const Console& console) {
  std::string text = report.file.empty() ? "\"\"" : visible_line(report.file);
  if (!report.format.empty()) text += " (" + report.format + ")";
  if (report.failure) return text + console.text(": refused\n", "：読み込めません\n").data();
  text +=
      report.status() == "ok" ? console.text(": ok\n", "：問題なし\n") : console.text(": warnings\n", "：警告あり\n");
  text += figures_text(report, console);
  const MeshKindRow& kind = row_of(report.kind.kind);
  text += "  " + std::string(console.text("kind ", "種類 ")) + std::string(console.text(kind.name_en, kind.name_ja)) +
          std::string(console.text(": ", "：")) + std::string(console.text(report.kind.reason)) + "\n";
  for (const NamedProblem& problem : report.problems) text += to_text(problem, console);
  return text;
}

}  // namespace ryosen::cli
