#include "app/cli/repair_report.h"

#include <algorithm>

namespace ryosen::cli {

namespace {

// "rounds: 2", then "boundary_loop: 1 -> 3 (+2)".
void print_findings(const RepairRun& run, const Console& console) {
  console.print(std::string(console.text("rounds: ", "巡回数：")) + std::to_string(run.rounds()) + "\n");
  for (const KindCount& kind : run.findings()) {
    if (kind.before == kind.after) continue;
    std::string line = "  " + std::string(row_of(kind.kind).id) + ": " + std::to_string(kind.before) + " -> " +
                       std::to_string(kind.after);
    if (kind.after > kind.before) line += " (+" + std::to_string(kind.after - kind.before) + ")";
    console.print(line + "\n");
  }
  if (const auto& [before, after] = run.boundary_edges(); before != after)
    console.print(std::string(console.text("  boundary edges: ", "  境界稜線：")) + std::to_string(before) + " -> " +
                  std::to_string(after) + "\n");
}

// The first faces of the loose pieces, as the output numbers its faces.
std::vector<std::string> loose_names(const RepairRun& run) {
  const Document& document = run.document();
  std::vector<std::uint32_t> aside;
  for (const QuarantinedFace& face : document.tables().quarantine) aside.push_back(face.face);
  std::sort(aside.begin(), aside.end());
  std::vector<std::string> names;
  std::size_t number = 0;
  std::uint32_t next = 0;
  for (const Element& face : run.loose()) {
    for (; next < face.index; ++next) number += document.mesh().is_alive(Face(next));
    const auto before = std::lower_bound(aside.begin(), aside.end(), face.index) - aside.begin();
    names.push_back("f" + std::to_string(number + static_cast<std::size_t>(before)));
  }
  return names;
}

// "loose pieces: 2 (f4, f5)", and how to be rid of them.
void print_loose(const RepairRun& run, const Console& console) {
  if (run.loose().empty()) return;
  constexpr std::size_t most_names = 8;
  const std::vector<std::string> all = loose_names(run);
  std::string names, words;
  for (std::size_t i = 0; i < std::min(most_names, all.size()); ++i) {
    names += (i == 0 ? "" : ", ") + all[i];
    words += " " + all[i];
  }
  if (all.size() > most_names) names += ", ...";
  const std::string count = std::to_string(all.size());
  const std::string script = "edit --do \"select" + words + "; select linked; delete selected\"\n";
  console.print(console.text(
      Text{"loose pieces: " + count + " (" + names + ")\n", "切り離された部分：" + count + "（" + names + "）\n"}));
  if (all.size() <= most_names)
    console.print(console.text(Text{"  to delete them: " + script, "  削除するには：" + script}));
}

}  // namespace

void print_repair(const RepairRun& run, const Console& console) {
  print_findings(run, console);
  print_loose(run, console);
}

void add_repair(Record<repair_shape>& json, const RepairRun& run, std::span<const Call> calls) {
  json["repairs"] = Json::array();
  for (const Call& call : calls) {
    const ParameterValue* const first = call.row->parameters.empty() ? nullptr : call.values.at(0);
    Record<repair_step_shape> repair;
    repair["kind"] = call.row->id;
    repair["number"] = first ? Json(first->number) : Json();
    add_result(repair, call, run.document().mesh());
    json["repairs"].push_back(std::move(repair).json());
  }
  json["rounds"] = run.rounds();
  json["boundary_edges"] = Json::object();
  json["boundary_edges"]["before"] = run.boundary_edges().first;
  json["boundary_edges"]["after"] = run.boundary_edges().second;
  json["findings"] = Json::array();
  for (const KindCount& kind : run.findings()) {
    Record<kind_count_shape> count;
    count["kind"] = row_of(kind.kind).id;
    count["before"] = kind.before;
    count["after"] = kind.after;
    json["findings"].push_back(std::move(count).json());
  }
}

}  // namespace ryosen::cli
