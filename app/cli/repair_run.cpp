#include "app/cli/repair_run.h"

#include <algorithm>

#include "app/cli/console.h"
#include "ryosen/algo/repair/side_effects.h"
#include "ryosen/io/formats.h"

namespace ryosen::cli {

namespace {

// Adds what a repair did in a further run.
AlgorithmResult joined(AlgorithmResult first, AlgorithmResult then) {
  if (first.changed == 0) return then;
  if (then.changed > 0) {
    first.text += Text{" ", ""} + then.text;
    first.changed += then.changed;
    if (then.crossings) first.crossings = first.crossings.value_or(0) + *then.crossings;
    first.drops_quarantined |= then.drops_quarantined;
  }
  first.left = then.left;
  first.left_for = std::move(then.left_for);
  return first;
}

// Tells that a repair was undone because its file would be no better.
AlgorithmResult undone_in_file(AlgorithmResult result) {
  result.left += result.changed;
  if (result.changed > 0)
    result.text = {"Undone, since points at one place are one in the file.",
                   "ファイルでは同じ位置の点が一つになるため、元に戻しました。"};
  result.changed = 0;
  result.crossings = {};
  result.drops_quarantined = false;
  return result;
}

// "weld_close=0.001" as --kinds has it, without initial values.
std::string name_of(const Call& call) {
  std::string name(call.row->id);
  char between = '=';
  for (const ParameterRow& row : call.row->parameters) {
    const std::string text = call.values.text(row.id);
    if (text.empty() || text == row.initial) continue;
    name += between + (&row == &call.row->parameters[0] ? text : std::string(row.id) + "=" + text);
    between = ' ';
  }
  return name;
}

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

std::optional<Failure> RepairRun::run(std::vector<Call>& calls) {
  calls_ = &calls;
  std::vector<std::string> names;
  std::vector<RecipeStep> steps;
  std::string command = "repair ";
  for (Call& call : calls) {
    command += (names.empty() ? "" : ",") + names.emplace_back(name_of(call));
    steps.push_back({call.row, call.values});
    if (auto failure = look_up_values(call, document().mesh())) return failure;
  }
  const RecipeEvents events = events_of(steps, names);
  if (job_.format && gives_back_others(document().file(), *job_.format)) {
    run_as_written(steps, command, events);
  } else {
    add_run(job_.document->run(steps, command, events).value());
    if (MeshFile file = document().contents(); job_.format && file.kept_vertices > 0)
      count_as_written({std::move(file), *job_.format});
  }
  for (const Call& call : calls)
    for (const LeftForReason& left : call.result.left_for)
      if (tells_of_loose_pieces(left)) loose_ = left.elements;
  return std::nullopt;
}

RecipeEvents RepairRun::events_of(std::span<const RecipeStep> steps, const std::vector<std::string>& names) {
  const auto name_in = [this, steps, &names](const RecipeStep& step, std::size_t round) {
    const std::string& name = names[static_cast<std::size_t>(&step - steps.data())];
    if (rounds_ + round == 1) return name;
    return std::string(console_.text("round ", "")) + std::to_string(rounds_ + round) +
           console_.text(", ", " 巡目、").data() + name;
  };
  RecipeEvents events;
  events.progress = [this, name_in](const RecipeStep& step, std::size_t round, double share) {
    return report_on(console_, name_in(step, round))(share);
  };
  events.step_done = [this, name_in](const RecipeStep& step, std::size_t round, const AlgorithmResult& result) {
    if (rounds_ + round == 1 || result.changed > 0) print(line_of_result(name_in(step, round), result, console_));
  };
  events.round_undone = [this](std::size_t round) {
    const std::string n = std::to_string(rounds_ + round);
    print(std::string(console_.text("round " + n + ": undone, since it takes away nothing that the repairs are for\n",
                                    n + " 巡目：対象の問題が減らないため、元に戻しました\n")));
  };
  return events;
}

void RepairRun::add_run(RecipeResult result) {
  if (rounds_ == 0) {
    findings_ = std::move(result.findings);
    boundary_edges_ = {result.boundary_edges_before, result.boundary_edges_after};
  }
  rounds_ += result.rounds;
  for (std::size_t i = 0; i < calls_->size(); ++i) {
    AlgorithmResult& sum = (*calls_)[i].result;
    sum = joined(std::move(sum), std::move(result.steps[i]));
  }
}

void RepairRun::run_as_written(std::span<const RecipeStep> steps, const std::string& command,
                               const RecipeEvents& events) {
  waits_ = true;
  while (!run_once(steps, command, events)) read_again();
  waits_ = false;
  if (was_no_better_ && rounds_ == 0)
    print(std::string(
        console_.text("nothing to do: points at one place are one in the file, which would have as many problems\n",
                      "変更なし：ファイルでは同じ位置の点が一つになり、問題が減らないため\n")));
}

// Runs the steps on the document, and undoes them where the file would be no better. What is found is counted as the
// file has it. Returns whether another run on what the file gives back would change nothing.
bool RepairRun::run_once(std::span<const RecipeStep> steps, const std::string& command, const RecipeEvents& events) {
  const WrittenMesh before(document().contents(), *job_.format);
  RecipeResult result = job_.document->run(steps, command, events).value();
  const bool is_changed = result.is_changed;
  std::optional<WrittenMesh> after;
  if (is_changed) after.emplace(document().contents(), *job_.format);
  const bool is_kept = after && RecipeGoal(steps).is_nearer(after->found(), before.found());
  if (is_changed && !is_kept) {
    job_.document->undo();
    was_no_better_ = true;
    result.rounds = 0;
    for (AlgorithmResult& step : result.steps) step = undone_in_file(std::move(step));
  }
  for (AlgorithmResult& step : result.steps) std::erase_if(step.left_for, tells_of_loose_pieces);  // one with the rest
  if (is_kept || !is_changed)
    for (const std::string& line : waiting_) console_.print_now(line);
  waiting_.clear();
  add_run(std::move(result));
  count_as_written(is_kept ? *after : before);
  return !is_kept && (reread_ || before.is_like(document()));
}

void RepairRun::count_as_written(const WrittenMesh& mesh) {
  for (KindCount& kind : findings_) kind.after = 0;
  mesh.count(&KindCount::after, findings_);
  boundary_edges_.second = mesh.boundary_edges();
}

// Reads the document as it would be written. What the format cannot hold is told now, since it is lost then.
void RepairRun::read_again() {
  std::vector<Message>& told = job_.given_up;
  if (job_.output)
    for (Message& loss : document().losses(*job_.output))
      if (std::none_of(told.begin(), told.end(), [&](const Message& m) { return m.code == loss.code; }))
        told.push_back(std::move(loss));
  MeshFile file = given_back(document().contents(), *job_.format);
  file.messages = document().file().messages;
  reread_ = std::make_unique<Document>(std::move(file), job_.input);
  job_.document = reread_.get();
}

// At once, unless what is done may be undone in the end.
void RepairRun::print(std::string line) {
  if (console_.json) return;
  if (waits_)
    waiting_.push_back(std::move(line));
  else
    console_.print_now(line);
}

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
