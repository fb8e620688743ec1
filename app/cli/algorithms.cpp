// `repair` and the subcommands of the algorithms: run them, report what was done and what is left.
#include <algorithm>

#include "app/cli/algorithm_call.h"
#include "app/cli/algorithm_flags.h"
#include "app/cli/check_report.h"
#include "app/cli/console.h"
#include "app/cli/contract/json.h"
#include "app/cli/distance_report.h"
#include "app/cli/edit_script.h"
#include "app/cli/outputs.h"
#include "app/cli/repair_run.h"
#include "app/cli/subcommand_table.h"
#include "app/editor/commands/commands.h"
#include "app/editor/commands/text/script.h"
#include "app/editor/document/repair_call.h"
#include "ryosen/algo/edge_rules.h"
#include "ryosen/io/formats.h"

namespace ryosen::cli {

namespace {

// Each repair once, in the order of the table; of two calls the later counts.
Result<std::vector<Call>> read_kinds(const std::string& list) {
  ReadRepairs read = read_repairs(list);
  if (read.fault) {
    Text hint{" Write default,ID=NUMBER.", "（書式：default,ID=NUMBER）"};
    if (!read.unknown.empty()) hint = did_you_mean(read.unknown, ids_of_repairs(), HintForm::sentence);
    if (read.misused) {
      const std::string syntax = std::string(read.misused->id) + kinds_syntax(*read.misused);
      hint = {" Write " + syntax + ".", "（書式：" + syntax + "）"};
    }
    return usage_failure("bad_value",
                         {"--kinds: " + read.fault->en + "." + hint.en, "--kinds：" + read.fault->ja + "。" + hint.ja});
  }
  std::vector<Call> calls;
  for (RecipeStep& step : read.call.steps) calls.push_back({step.row, std::move(step.values)});
  return calls;
}

class AlgorithmRun {
 public:
  // By `repair` each call is one of a list, else there is only one.
  AlgorithmRun(AlgorithmJob job, RunFiles files, const Console& console, bool by_repair, bool wants_distance)
      : job_(std::move(job)),
        files_(std::move(files)),
        console_(console),
        by_repair_(by_repair),
        wants_distance_(wants_distance) {}

  ExitCode run(std::vector<Call> calls) {
    calls_ = std::move(calls);
    if (const auto failure = by_repair_ ? repair() : run(calls_.front())) return console_.fail(*failure, job_.input);
    // What is left is named as in the file that is written.
    MeshFile contents = job_.document->contents();
    if (job_.format) contents = given_back(std::move(contents), *job_.format);
    after_ =
        check_mesh(std::move(contents), job_.output.value_or(job_.input), {.figures = console_.json, .kind = false});
    const bool wants_points = !by_repair_ && calls_.front().row->adds_points;
    has_problem_ = std::any_of(after_.problems.begin(), after_.problems.end(), [&](const NamedProblem& p) {
      return p.problem.row().severity == ProblemSeverity::problem &&
             !(wants_points && p.problem.row().kind == ProblemKind::isolated_vertex);
    });
    code_ = falls_short() ? ExitCode::found_problems : ExitCode::done;
    if (job_.output) write();
    if (!console_.json)
      print_text();
    else if (by_repair_)
      print_json<repair_shape>();
    else
      goal_report() ? print_json<goal_shape>() : print_json<algorithm_shape>();
    return code_;
  }

 private:
  // The report of an algorithm with a goal, which no repair has; null for others.
  const GoalReport* goal_report() const {
    const std::optional<GoalReport>& given = calls_.front().result.goal_report;
    return !by_repair_ && given ? &*given : nullptr;
  }
  // One with a goal is asked for the goal, every other for what is left.
  bool falls_short() const { return goal_report() ? !goal_report()->is_reached : has_problem_; }

  std::optional<Failure> repair() { return repair_.emplace(job_, console_).run(calls_); }

  std::optional<Failure> run(Call& call) {
    const std::string line = AlgorithmCall{call.row, call.values}.line(), values = call.values.line();
    const std::string name = std::string(call.row->id) + (values.empty() ? "" : " ") + values;
    if (auto failure = look_up_values(call, job_.document->mesh())) return failure;
    faces_before_ = job_.document->mesh().live().faces + job_.document->tables().quarantine.size();
    const std::optional<Mesh> before = wants_distance_ ? std::optional(job_.document->mesh()) : std::nullopt;
    call.result =
        job_.document->run(*call.row, call.values, line, report_on(console_, name), {.edge_rules = console_.json})
            .value();
    if (const std::optional<Text>& fault = call.result.fault)
      return usage_failure("bad_value", {fault->en + ".", fault->ja + "。"});
    if (const std::optional<Text>& refused = call.result.refused)
      return make_failure(ExitCode::refused, "mesh_refused", {refused->en + ".", refused->ja + "。"});
    if (!console_.json) console_.print_now(line_of_result(name, call.result, console_));
    if (before) measure_distance_from(*before);
    return std::nullopt;
  }

  // None where there is nothing to measure.
  void measure_distance_from(const Mesh& before) {
    if (!has_surface(before) || !has_surface(job_.document->mesh())) return;
    Progress progress(report_on(console_, "distance"));
    distance_ = surface_distance(before, job_.document->mesh(), {}, progress);
    if (!distance_ || console_.json) return;
    DistanceTable table(console_);
    table.add(std::string(console_.text("distance", "距離")), *distance_, distance_->diagonal);
    console_.print_now(table.text());
  }

  void write() {
    output_ = write_output(*job_.document, files_, *job_.output, false, console_, job_.given_up);
    if (output_.failure) code_ = output_.failure->exit_code;
  }

  void print_text() const {
    if (repair_) print_repair(*repair_, console_);
    console_.print(after_.problems.empty() ? console_.text("left: nothing\n", "残り：なし\n")
                                           : console_.text("left:\n", "残り：\n"));
    for (const NamedProblem& problem : after_.problems) console_.print(to_text(problem, console_));
    console_.conclude(written_text(output_.is_there ? &*job_.output : nullptr, console_), code_);
  }

  void add_to(Record<repair_shape>& json) const { add_repair(json, *repair_, calls_); }

  void add_to(Record<algorithm_shape>& json) const {
    json["algorithm"] = calls_.front().row->id;
    add_result(json, calls_.front(), job_.document->mesh());
  }

  void add_to(Record<goal_shape>& json) const {
    json["algorithm"] = calls_.front().row->id;
    add_result(json, calls_.front(), job_.document->mesh());
    json["faces_before"] = faces_before_;
    json["faces_after"] = after_.figures.faces;
    json["stopped"] = id_of(goal_report()->stopped);
    json["remaining"] = Json::object();
    for (const EdgeRuleRow& row : edge_rule_table()) {
      const auto i = static_cast<std::size_t>(row.rule);
      const std::vector<std::size_t>& counts = goal_report()->remaining;
      json["remaining"][std::string(row.id)] = !counts.empty()              ? counts[i]
                                               : row.rule == EdgeRule::free ? after_.figures.edges
                                                                            : 0;
    }
    json["error_max"] = or_null(goal_report()->error_max);
    json["distance"] = Json();
    if (!distance_) return;
    Record<result_distance_shape> distance;
    add_figures(distance, *distance_, distance_->diagonal);
    json["distance"] = std::move(distance).json();
  }

  template <const Shape& shape>
  void print_json() const {
    Record<shape> json;
    json["file"] = job_.input.empty() ? Json() : Json(job_.input);
    json["output"] = output_.is_there ? Json(*job_.output) : Json();
    json["status"] = output_.failure                                                      ? "error"
                     : code_ == ExitCode::done && !has_problem_ && output_.losses.empty() ? "ok"
                                                                                          : "warnings";
    add_to(json);
    json["vertices"] = after_.figures.vertices;
    json["edges"] = after_.figures.edges;
    json["faces"] = after_.figures.faces;
    json["hash"] = after_.hash;
    json["problems"] = array_of(after_.problems, [](const NamedProblem& problem) { return cli::to_json(problem); });
    std::vector<Message> messages =
        output_.failure ? std::vector{output_.failure->message} : job_.document->file().messages;
    messages.insert(messages.end(), output_.losses.begin(), output_.losses.end());
    json["messages"] = cli::to_json(messages);
    console_.conclude(line_of(json), code_);
  }

  AlgorithmJob job_;
  RunFiles files_;
  const Console& console_;
  bool by_repair_, wants_distance_;
  std::vector<Call> calls_;
  std::optional<RepairRun> repair_;
  CheckReport after_;
  std::size_t faces_before_ = 0;
  std::optional<SurfaceDistance> distance_;
  bool has_problem_ = false;
  WrittenOutput output_;
  ExitCode code_ = ExitCode::done;
};

// Without a file on an empty mesh.
ExitCode run_on_file(std::vector<Call> calls, const Arguments& arguments, const Console& given, bool by_repair) {
  const std::string input = arguments.operands().empty() ? std::string() : arguments.operands()[0];
  const std::string* const output = arguments.value("-o");
  std::vector<PlannedOutput> outputs;
  if (output) outputs.push_back({*output, FileRole::result});
  const RunFiles files = files_of_run(arguments, input);
  RunFiles planned = files;
  if (const auto fault = find_fault({}, input, outputs, planned)) return given.fail(*fault, input);
  Console console = given;
  console.leaves_stdout = planned.uses_stdout();
  Result<MeshFile> file = arguments.operands().empty() ? Result<MeshFile>(MeshFile()) : read_mesh_file(input);
  if (!file) return console.fail(file.failure(), input);
  for (const Message& message : file->messages) console.show(message, input);
  std::vector<Message> given_up;
  const Format* const format = output ? format_to_write(*output, *file) : file->format;
  if (output && format) given_up = give_up_lost_elements(*file, *format);
  Document document(std::move(file).value(), input);
  AlgorithmJob job{&document, input, output ? std::optional(*output) : std::nullopt, format, std::move(given_up)};
  return AlgorithmRun(std::move(job), files, console, by_repair, arguments.has("--distance")).run(std::move(calls));
}

}  // namespace

ExitCode repair_command(const Arguments& arguments, const Console& console) {
  const std::string* const kinds = arguments.value("--kinds");
  Result<std::vector<Call>> calls = read_kinds(kinds ? *kinds : "default");
  if (!calls) return console.fail(calls.failure());
  return run_on_file(std::move(calls).value(), arguments, console, true);
}

ExitCode algorithm_command(const AlgorithmRow& row, const Arguments& arguments, const Console& console) {
  ParameterValues values(row.parameters);
  const auto fail = [&](const Text& sentence) {
    return console.fail(usage_failure("bad_value", {sentence.en + ".", sentence.ja + "。"}));
  };
  for (const ParameterRow& parameter : row.parameters) {
    const std::string flag = flag_of(parameter);
    const std::string* const text = arguments.value(flag);
    if (!text) continue;
    const bool is_switch = parameter.kind == ParameterKind::flag && text->empty();
    if (const auto fault = values.set(parameter.id, is_switch ? "on" : *text, flag)) return fail(*fault);
  }
  if (const auto fault = values.fault_of_missing(flag_of)) return fail(*fault);
  return run_on_file({{&row, std::move(values)}}, arguments, console, false);
}

}  // namespace ryosen::cli
