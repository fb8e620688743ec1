// `repair` and the subcommands of the algorithms: run them, report what was done and what is left.
#include <algorithm>
#include <memory>

#include "app/cli/algorithm_flags.h"
#include "app/cli/check_report.h"
#include "app/cli/contract/algorithms.h"
#include "app/cli/contract/record.h"
#include "app/cli/distance_report.h"
#include "app/cli/edit_script.h"
#include "app/cli/json.h"
#include "app/cli/outputs.h"
#include "app/cli/progress_line.h"
#include "app/cli/subcommands.h"
#include "app/cli/write_output.h"
#include "app/cli/written_mesh.h"
#include "app/editor/commands/commands.h"
#include "app/editor/commands/script.h"
#include "app/editor/document/repair_call.h"
#include "ryosen/algo/edge_rules.h"
#include "ryosen/algo/repair/loose_pieces.h"
#include "ryosen/io/given_back.h"
#include "ryosen/mesh/find_element.h"
#include "ryosen/mesh/names.h"

namespace ryosen::cli {

namespace {

struct Call {
  const AlgorithmRow* row;
  ParameterValues values;  // as given; on the mesh once it is done
  AlgorithmResult result = {};
};

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

Json value_json(const ParameterRow& row, const ParameterValue* value) {
  if (!value) return nullptr;
  switch (row.kind) {
    case ParameterKind::count:
      return static_cast<std::uint64_t>(value->number);
    case ParameterKind::choice:
      return row.choices[static_cast<std::size_t>(value->number)].id;
    case ParameterKind::flag:
      return value->number != 0;
    case ParameterKind::place:
      return Json::array({value->place.x, value->place.y, value->place.z});
    case ParameterKind::elements:
      return value->names;
    default:
      return value->number;
  }
}

class AlgorithmRun {
 public:
  // By `repair` each call is one of a list, else there is only one.
  // `given_up`: the warnings about what the document has lost already for the sake of the format of the output. `format`:
  // that of the output, or of the input where there is none; null: what is left is counted on the mesh.
  AlgorithmRun(Document& document, std::string input, std::optional<std::string> output, const Format* format,
               std::vector<Message> given_up, RunFiles files, const Console& console, bool by_repair,
               bool wants_distance)
      : document_(&document),
        input_(std::move(input)),
        wanted_(std::move(output)),
        format_(format),
        given_up_(std::move(given_up)),
        files_(std::move(files)),
        console_(console),
        by_repair_(by_repair),
        wants_distance_(wants_distance) {}

  ExitCode run(std::vector<Call> calls) {
    calls_ = std::move(calls);
    if (const auto failure = by_repair_ ? run_recipe() : run(calls_.front())) return console_.fail(*failure, input_);
    // What is left is named as in the file that is written.
    MeshFile contents = document_->contents();
    if (format_) contents = given_back(std::move(contents), *format_);
    after_ = check_mesh(std::move(contents), wanted_.value_or(input_), {.figures = console_.json, .kind = false});
    const bool wants_points = !by_repair_ && calls_.front().row->adds_points;
    has_problem_ = std::any_of(after_.problems.begin(), after_.problems.end(), [&](const NamedProblem& p) {
      return p.problem.row().severity == ProblemSeverity::problem &&
             !(wants_points && p.problem.row().kind == ProblemKind::isolated_vertex);
    });
    code_ = falls_short() ? ExitCode::found_problems : ExitCode::done;
    if (wanted_) write();
    if (!console_.json)
      print_text();
    else if (by_repair_)
      print_json<repair_shape>();
    else
      account() ? print_json<accounting_shape>() : print_json<algorithm_shape>();
    return code_;
  }

 private:
  // Of one that accounts; by repair none does.
  const Account* account() const {
    const std::optional<Account>& given = calls_.front().result.account;
    return !by_repair_ && given ? &*given : nullptr;
  }
  // One with a goal is asked for the goal, every other for what is left.
  bool falls_short() const { return account() ? !account()->is_reached : has_problem_; }

  // "weld_close=0.001" as --kinds has it, without initial values, or the line of a script.
  std::string name_of(const Call& call) const {
    std::string name(call.row->id);
    if (!by_repair_) {
      const std::string values = call.values.line();
      return name + (values.empty() ? "" : " " + values);
    }
    char between = '=';
    for (const ParameterRow& row : call.row->parameters) {
      const std::string text = call.values.text(row.id);
      if (text.empty() || text == row.initial) continue;
      name += between + (&row == &call.row->parameters[0] ? text : std::string(row.id) + "=" + text);
      between = ' ';
    }
    return name;
  }

  // Gives the call the values on this mesh.
  std::optional<Failure> look_up_values(Call& call) {
    ReadValues found = call.values.on(document_->mesh());
    if (found.lacks_extent)
      return make_failure(ExitCode::refused, "mesh_refused", {found.sentence.en + ".", found.sentence.ja + "。"});
    if (!found.values) return usage_failure("bad_value", {found.sentence.en + ".", found.sentence.ja + "。"});
    call.values = std::move(*found.values);
    return std::nullopt;
  }

  // At once, unless what is done may be undone in the end.
  void print_step(const std::string& name, const AlgorithmResult& result) {
    if (console_.json) return;
    const std::string line = name + console_.text(": ", "：").data() + console_.text(result.text) + "\n";
    if (waits_)
      waiting_.push_back(line);
    else
      console_.print_now(line);
  }

  std::optional<Failure> run_recipe() {
    std::vector<std::string> names;
    std::vector<RecipeStep> steps;
    std::string kinds;
    for (Call& call : calls_) {
      kinds += (names.empty() ? "" : ",") + names.emplace_back(name_of(call));
      steps.push_back({call.row, call.values});
      if (auto failure = look_up_values(call)) return failure;
    }
    const auto name_in = [&](const RecipeStep& step, std::size_t round) {
      const std::string name = names[static_cast<std::size_t>(&step - steps.data())];
      if (round == 1) return name;
      return std::string(console_.text("round ", "")) + std::to_string(round) + console_.text(", ", " 巡目、").data() +
             name;
    };
    RecipeEvents events;
    events.progress = [&](const RecipeStep& step, std::size_t round, double share) {
      return report_on(console_, name_in(step, rounds_ + round))(share);
    };
    events.step_done = [&](const RecipeStep& step, std::size_t round, const AlgorithmResult& result) {
      if (rounds_ + round == 1 || result.changed > 0) print_step(name_in(step, rounds_ + round), result);
    };
    events.round_undone = [&](std::size_t round) { print_undone(rounds_ + round); };
    if (format_ && gives_back_others(document_->file(), *format_))
      run_as_written(steps, "repair " + kinds, events);
    else
      add_run(document_->run(steps, "repair " + kinds, events).value());
    for (const Call& call : calls_)
      for (const LeftForReason& left : call.result.left_for)
        if (tells_of_loose_pieces(left)) loose_ = left.elements;
    return std::nullopt;
  }

  void add_run(RecipeResult result) {
    if (rounds_ == 0) {
      findings_ = std::move(result.findings);
      boundary_edges_ = {result.boundary_edges_before, result.boundary_edges_after};
    }
    rounds_ += result.rounds;
    for (std::size_t i = 0; i < calls_.size(); ++i)
      calls_[i].result = joined(std::move(calls_[i].result), std::move(result.steps[i]));
  }

  // Runs the steps on the document, and again on what its file gives back, where points at one place are one, until they
  // make that no better. A run that does not is undone. What is found is counted as the file has it.
  void run_as_written(std::span<const RecipeStep> steps, const std::string& command, const RecipeEvents& events) {
    const RecipeGoal goal(steps);
    waits_ = true;
    bool was_no_better = false;
    for (bool is_over = false; !is_over;) {
      const WrittenMesh before(document_->contents(), *format_);
      RecipeResult result = document_->run(steps, command, events).value();
      const bool is_changed = result.is_changed;
      std::optional<WrittenMesh> after;
      if (is_changed) after.emplace(document_->contents(), *format_);
      const bool is_kept = after && goal.is_nearer(after->found(), before.found());
      if (is_changed && !is_kept) {
        document_->undo();
        result.rounds = 0;
        for (AlgorithmResult& step : result.steps) step = undone_in_file(std::move(step));
      }
      for (AlgorithmResult& step : result.steps)
        std::erase_if(step.left_for, tells_of_loose_pieces);  // one with the rest
      print_waiting(is_kept || !is_changed);
      was_no_better = was_no_better || (is_changed && !is_kept);
      add_run(std::move(result));
      count_as_written(is_kept ? *after : before);
      is_over = !is_kept && (reread_ || before.is_like(*document_));
      if (!is_over) read_again();
    }
    waits_ = false;
    if (was_no_better && rounds_ == 0) print_no_better();
  }

  void count_as_written(const WrittenMesh& mesh) {
    for (KindCount& kind : findings_) kind.after = 0;
    mesh.count(&KindCount::after, findings_);
    boundary_edges_.second = mesh.boundary_edges();
  }

  // Reads the document as it would be written. What the format cannot hold is told now, since it is lost then.
  void read_again() {
    if (wanted_)
      for (Message& loss : document_->losses(*wanted_))
        if (std::none_of(given_up_.begin(), given_up_.end(), [&](const Message& m) { return m.code == loss.code; }))
          given_up_.push_back(std::move(loss));
    MeshFile file = given_back(document_->contents(), *format_);
    file.messages = document_->file().messages;
    reread_ = std::make_unique<Document>(std::move(file), input_);
    document_ = reread_.get();
  }

  void print_waiting(bool prints) {
    for (const std::string& line : waiting_)
      if (prints) console_.print_now(line);
    waiting_.clear();
  }

  void print_no_better() const {
    if (!console_.json)
      console_.print_now(std::string(
          console_.text("nothing to do: points at one place are one in the file, which would have as many problems\n",
                        "変更なし：ファイルでは同じ位置の点が一つになり、問題が減らないため\n")));
  }

  void print_undone(std::size_t round) const {
    const std::string n = std::to_string(round);
    if (!console_.json)
      console_.print_now(
          std::string(console_.text("round " + n + ": undone, since it takes away nothing that the repairs are for\n",
                                    n + " 巡目：対象の問題が減らないため、元に戻しました\n")));
  }

  std::optional<Failure> run(Call& call) {
    const std::string name = name_of(call), line = line_of(*call.row, call.values);
    if (auto failure = look_up_values(call)) return failure;
    faces_before_ = document_->mesh().live().faces + document_->tables().quarantine.size();
    const std::optional<Mesh> before = wants_distance_ ? std::optional(document_->mesh()) : std::nullopt;
    call.result =
        document_->run(*call.row, call.values, line, report_on(console_, name), {.account = console_.json}).value();
    if (const std::optional<Text>& fault = call.result.fault)
      return usage_failure("bad_value", {fault->en + ".", fault->ja + "。"});
    if (const std::optional<Text>& refused = call.result.refused)
      return make_failure(ExitCode::refused, "mesh_refused", {refused->en + ".", refused->ja + "。"});
    print_step(name, call.result);
    if (before) measure_distance_from(*before);
    return std::nullopt;
  }

  void print_distance() const {
    DistanceTable table(console_);
    table.add(std::string(console_.text("distance", "距離")), *distance_, distance_->diagonal);
    console_.print_now(table.text());
  }

  // None where there is nothing to measure.
  void measure_distance_from(const Mesh& before) {
    if (!has_surface(before) || !has_surface(document_->mesh())) return;
    Progress progress(report_on(console_, "distance"));
    distance_ = surface_distance(before, document_->mesh(), {}, progress);
    if (distance_ && !console_.json) print_distance();
  }

  void write() {
    output_ = write_output(*document_, files_, *wanted_, false, console_, given_up_);
    if (output_.failure) code_ = output_.failure->exit_code;
  }

  // "rounds: 2", then "boundary_loop: 1 -> 3 (+2)" for each kind of which the number is another now.
  void print_findings() const {
    console_.print(std::string(console_.text("rounds: ", "巡回数：")) + std::to_string(rounds_) + "\n");
    for (const KindCount& kind : findings_) {
      if (kind.before == kind.after) continue;
      std::string line = "  " + std::string(row_of(kind.kind).id) + ": " + std::to_string(kind.before) + " -> " +
                         std::to_string(kind.after);
      if (kind.after > kind.before) line += " (+" + std::to_string(kind.after - kind.before) + ")";
      console_.print(line + "\n");
    }
    if (const auto [before, after] = boundary_edges_; before != after)
      console_.print(std::string(console_.text("  boundary edges: ", "  境界稜線：")) + std::to_string(before) +
                     " -> " + std::to_string(after) + "\n");
  }

  // The first faces of the loose pieces, as the output numbers its faces.
  std::vector<std::string> loose_names() const {
    std::vector<std::uint32_t> aside;
    for (const QuarantinedFace& face : document_->tables().quarantine) aside.push_back(face.face);
    std::sort(aside.begin(), aside.end());
    std::vector<std::string> names;
    std::size_t number = 0;
    std::uint32_t next = 0;
    for (const Element& face : loose_) {
      for (; next < face.index; ++next) number += document_->mesh().is_alive(Face(next));
      const auto before = std::lower_bound(aside.begin(), aside.end(), face.index) - aside.begin();
      names.push_back("f" + std::to_string(number + static_cast<std::size_t>(before)));
    }
    return names;
  }

  // "loose pieces: 2 (f4, f5)", and how to be rid of them.
  void print_loose() const {
    if (loose_.empty()) return;
    constexpr std::size_t most_names = 8;
    const std::vector<std::string> all = loose_names();
    std::string names, words;
    for (std::size_t i = 0; i < std::min(most_names, all.size()); ++i) {
      names += (i == 0 ? "" : ", ") + all[i];
      words += " " + all[i];
    }
    if (all.size() > most_names) names += ", ...";
    const std::string count = std::to_string(all.size());
    const std::string script = "edit --do \"select" + words + "; select linked; delete selected\"\n";
    console_.print(console_.text(
        Text{"loose pieces: " + count + " (" + names + ")\n", "切り離された部分：" + count + "（" + names + "）\n"}));
    if (all.size() <= most_names)
      console_.print(console_.text(Text{"  to delete them: " + script, "  削除するには：" + script}));
  }

  void print_text() const {
    if (by_repair_) print_findings();
    if (by_repair_) print_loose();
    console_.print(after_.problems.empty() ? console_.text("left: nothing\n", "残り：なし\n")
                                           : console_.text("left:\n", "残り：\n"));
    for (const NamedProblem& problem : after_.problems) console_.print(to_text(problem, console_));
    console_.conclude(written_text(output_.is_there ? &*wanted_ : nullptr, console_), code_);
  }

  Json reason_json(const LeftForReason& left) const {
    Record<left_shape> json;
    json["elements"] = Json::array();
    for (const Element& element : left.elements)
      if (is_alive(document_->mesh(), element)) json["elements"].push_back(ryosen::name_of(document_->mesh(), element));
    json.put(left.reason);
    return std::move(json).json();
  }

  template <const Shape& shape>
  void add_result(Record<shape>& json, const Call& call) const {
    json["parameters"] = Json::object();
    for (std::size_t i = 0; i < call.row->parameters.size(); ++i) {
      const ParameterRow& row = call.row->parameters[i];
      json["parameters"][std::string(row.id)] = value_json(row, call.values.at(i));
    }
    json["changed"] = call.result.changed;
    json["left"] = call.result.left;
    json["left_for"] = Json::array();
    for (const LeftForReason& left : call.result.left_for) json["left_for"].push_back(reason_json(left));
    json["crossings"] = call.result.crossings ? Json(*call.result.crossings) : Json();
    json["solves"] = Json::array();
    for (ProblemKind kind : call.row->solves) json["solves"].push_back(row_of(kind).id);
    json.put(call.result.text);
  }

  void add_to(Record<repair_shape>& json) const {
    json["repairs"] = Json::array();
    for (const Call& call : calls_) {
      const ParameterValue* const first = call.row->parameters.empty() ? nullptr : call.values.at(0);
      Record<repair_step_shape> repair;
      repair["kind"] = call.row->id;
      repair["number"] = first ? Json(first->number) : Json();
      add_result(repair, call);
      json["repairs"].push_back(std::move(repair).json());
    }
    json["rounds"] = rounds_;
    json["boundary_edges"] = Json::object();
    json["boundary_edges"]["before"] = boundary_edges_.first;
    json["boundary_edges"]["after"] = boundary_edges_.second;
    json["findings"] = Json::array();
    for (const KindCount& kind : findings_) {
      Record<kind_count_shape> count;
      count["kind"] = row_of(kind.kind).id;
      count["before"] = kind.before;
      count["after"] = kind.after;
      json["findings"].push_back(std::move(count).json());
    }
  }

  void add_to(Record<algorithm_shape>& json) const {
    json["algorithm"] = calls_.front().row->id;
    add_result(json, calls_.front());
  }

  void add_to(Record<accounting_shape>& json) const {
    json["algorithm"] = calls_.front().row->id;
    add_result(json, calls_.front());
    json["faces_before"] = faces_before_;
    json["faces_after"] = after_.figures.faces;
    json["stopped"] = id_of(account()->stopped);
    json["remaining"] = Json::object();
    for (const EdgeRuleRow& row : edge_rules) {
      const auto i = static_cast<std::size_t>(row.rule);
      const std::vector<std::size_t>& counts = account()->remaining;
      json["remaining"][std::string(row.id)] = !counts.empty()              ? counts[i]
                                               : row.rule == EdgeRule::free ? after_.figures.edges
                                                                            : 0;
    }
    json["error_max"] = account()->error_max ? Json(*account()->error_max) : Json();
    json["distance"] = Json();
    if (!distance_) return;
    Record<result_distance_shape> distance;
    add_figures(distance, *distance_, distance_->diagonal);
    json["distance"] = std::move(distance).json();
  }

  template <const Shape& shape>
  void print_json() const {
    Record<shape> json;
    json["file"] = input_.empty() ? Json() : Json(input_);
    json["output"] = output_.is_there ? Json(*wanted_) : Json();
    json["status"] = output_.failure                                                      ? "error"
                     : code_ == ExitCode::done && !has_problem_ && output_.losses.empty() ? "ok"
                                                                                          : "warnings";
    add_to(json);
    json["vertices"] = after_.figures.vertices;
    json["edges"] = after_.figures.edges;
    json["faces"] = after_.figures.faces;
    json["hash"] = after_.hash;
    json["problems"] = Json::array();
    for (const NamedProblem& problem : after_.problems) json["problems"].push_back(cli::to_json(problem));
    std::vector<Message> messages =
        output_.failure ? std::vector{output_.failure->message} : document_->file().messages;
    messages.insert(messages.end(), output_.losses.begin(), output_.losses.end());
    json["messages"] = cli::to_json(messages);
    console_.conclude(line_of(json), code_);
  }

  Document* document_;
  std::unique_ptr<Document> reread_;   // where the document is read again from what would be written
  std::string input_;                  // empty where it began with an empty mesh
  std::optional<std::string> wanted_;  // -o
  const Format* format_;
  std::vector<Message> given_up_;
  RunFiles files_;
  const Console& console_;
  bool by_repair_, wants_distance_;
  std::vector<Call> calls_;
  bool waits_ = false;
  std::vector<std::string> waiting_;  // lines
  std::size_t rounds_ = 0;
  std::vector<KindCount> findings_;
  std::pair<std::size_t, std::size_t> boundary_edges_;  // before, after
  std::vector<Element> loose_;                          // their first faces
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
  return AlgorithmRun(document, input, output ? std::optional(*output) : std::nullopt, format, std::move(given_up),
                      files, console, by_repair, arguments.has("--distance"))
      .run(std::move(calls));
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
