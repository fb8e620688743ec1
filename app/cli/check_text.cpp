// The human-readable report of `check`.
#include <algorithm>
#include <cstdio>
#include <map>
#include <set>

#include "app/cli/check_report.h"
#include "app/cli/columns.h"
#include "app/cli/contract/check.h"
#include "app/cli/visible.h"
#include "ryosen/analysis/boundary_loops.h"
#include "ryosen/analysis/figures.h"
#include "ryosen/ops/op.h"

namespace ryosen::cli {

namespace {

constexpr std::size_t names_shown = 8;

std::string spaces(std::size_t wanted, std::size_t used) { return std::string(wanted > used ? wanted - used : 1, ' '); }

std::string number(std::uint64_t n) { return std::to_string(n); }

std::string short_number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", x);
  return text;
}

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
