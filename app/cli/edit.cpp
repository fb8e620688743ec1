// `edit`: runs commands on a mesh and writes the result, or nothing at all.
#include <algorithm>
#include <memory>

#include "app/cli/contract/json.h"
#include "app/cli/contract/operators.h"
#include "app/cli/edit_script.h"
#include "app/cli/outputs.h"
#include "app/cli/subcommand_table.h"
#include "app/cli/sudden_end.h"
#include "app/editor/commands/commands.h"
#include "app/editor/commands/expect.h"
#include "app/editor/document/written_mesh.h"
#include "app/editor/session/session.h"
#include "ryosen/analysis/figures.h"
#include "ryosen/mesh/copies.h"

namespace ryosen::cli {

namespace {

struct EditFiles {
  std::string input;
  std::optional<std::string> output;
  RunFiles of_run;
};

// The result of one command for the report.
struct Step {
  ScriptLine line;
  std::string_view result = "skipped";
  Outcome outcome;
  Json reasons = Json::array(), warnings = Json::array();
  std::string rules;   // ids of the broken ones
  std::string remedy;  // shown with a refusal; may be empty
};

struct Totals {
  std::uint64_t vertices, edges, faces, rings;
};

// The mesh after the last command.
struct LastState {
  Totals totals;
  ElementCounts all;  // as `expect` counts
  std::string hash;   // for JSON alone
};

class EditRun {
 public:
  EditRun(std::unique_ptr<Document> document, EditFiles files, const EditScript& script, bool skip_refused, bool strict,
          const Console& console)
      : files_(std::move(files)),
        script_(script),
        skip_refused_(skip_refused),
        console_(console),
        session_(std::move(document)) {
    session_.frontend.is_strict = strict;
    session_.shown.has_view = false;
    session_.files = files_.of_run;
    session_.frontend.quit = [this] { stopped_ = true; };
  }

  ExitCode run() {
    const Totals before = totals();
    for (const ScriptLine& line : script_.lines) {
      Step step;
      step.line = line;
      begin_another_step();
      if (!stopped_) take(step);
      report(step);
    }
    session_.shown.end();
    // Before the file is there: after it the run is to end soon.
    const LastState last{totals(), counts_on_points(session_.mesh()),
                         console_.json ? hash_text(session_.mesh()) : std::string()};
    if (may_write() && files_.output) write();
    if (console_.json)
      print_json(last);
    else
      print_text(before, last);
    return code_;
  }

 private:
  bool may_write() const { return code_ == ExitCode::done || (code_ == ExitCode::found_problems && !failed_); }

  void take(Step& step) {
    // Warnings name elements of the document, as before the operator.
    if (const auto call = call_of(step.line.text); call && session_.shown.response(call->effect) != Response::keep)
      session_.shown.end();
    const ParsedOp parsed =
        find_op(split_words(step.line.text)[0]) ? parse_line(session_.mesh(), step.line.text) : ParsedOp();
    if (parsed.op && console_.json)
      step.warnings = to_json(session_.mesh(), session_.document().preview(*parsed.op).warnings);
    step.outcome = session_.run(step.line.text);
    if (step.outcome.done()) {
      step.result = "done";
      ++applied_;
      const auto performed = call_of(step.outcome.performed);
      if (!performed || performed->effect != Effect::writes) return;
      const std::string named = file_of(*performed);
      note_saved(named.empty() ? session_.document().path().string() : named);
      return;
    }
    // A save may fail after the file has been replaced.
    if (const auto performed = call_of(step.outcome.performed); performed && performed->effect == Effect::writes)
      note_saved(file_of(*performed));
    if (step.outcome.exit_code != ExitCode::refused) {
      step.result = "failed";
      failed_ = stopped_ = true;
      code_ = step.outcome.exit_code;
      return;
    }
    step.result = "refused";
    ++refused_;
    describe_refusal(step, parsed);
    code_ = skip_refused_ ? ExitCode::found_problems : ExitCode::refused;
    stopped_ = !skip_refused_;
  }

  void note_saved(const std::string& path) {
    written_ = path;
    if (std::find(saved_.begin(), saved_.end(), path) == saved_.end()) saved_.push_back(path);
  }

  void describe_refusal(Step& step, const ParsedOp& parsed) {
    step.reasons = to_json(session_.mesh(), step.outcome.reasons);
    std::vector<std::string_view> rules;
    for (const Reason& reason : step.outcome.reasons) rules.push_back(text_of(reason.rule).id);
    rules.erase(std::unique(rules.begin(), rules.end()), rules.end());  // they stand in the order of the rules
    for (const std::string_view rule : rules) step.rules.append(step.rules.empty() ? "" : ", ").append(rule);
    if (!parsed.op) return;
    for (const std::string& line : session_.document().remedy(step.line.text))
      step.remedy += (step.remedy.empty() ? "" : "; ") + line;
  }

  Message message_of(const Step& step) const {
    Message message;
    message.severity = step.result == "refused" && skip_refused_ ? Severity::warning : Severity::error;
    message.code = code_of(step.outcome);
    message.text = step.outcome.sentence;
    const std::string rules = step.rules.empty() ? "" : " [" + step.rules + "]";
    message.text += Text{rules, rules};
    if (!step.remedy.empty()) message.text += Text{" Remedy: " + step.remedy, " 対処：" + step.remedy};
    if (stopped_ && !saved_.empty()) {
      std::string names;
      for (const std::string& name : saved_) names += (names.empty() ? "" : ", ") + name;
      message.text += Text{" (saved before: " + names + ")", "（ここまでに保存：" + names + "）"};
    }
    message.line = static_cast<std::uint64_t>(step.line.line);
    return message;
  }

  void report(const Step& step) {
    const bool has_message = step.result == "refused" || step.result == "failed";
    if (has_message) console_.show(message_of(step), script_.place());
    if (step.outcome.done() && !step.outcome.sentence.en.empty()) console_.note(step.outcome.sentence);
    if (console_.json)
      print_json(step, has_message);
    else if (console_.verbose)
      console_.print(step.line.text + ": " + std::string(step.result) + "\n");
  }

  void print_json(const Step& step, bool has_message) {
    Record<edit_step_shape> json;
    json["line"] = step.line.line;
    json["command"] = step.line.text;
    json["result"] = step.result;
    json["created"] = step.outcome.created;
    json["deleted"] = step.outcome.deleted;
    json["reasons"] = step.reasons;
    json["warnings"] = step.warnings;
    if (has_message) json["messages"] = Json::array({to_json(message_of(step))});
    console_.print(line_of(json));
  }

  void write() {
    begin_another_step();
    output_ = write_output(session_.document(), session_.files, *files_.output, session_.frontend.is_strict, console_);
    if (output_.is_there) written_ = *files_.output;
    if (!output_.failure) {
      if (const auto found = file_findings_text(session_.document(), *files_.output)) console_.note(*found);
      return;
    }
    code_ = output_.failure->exit_code;
    failed_ = true;
  }

  Totals totals() {
    const Figures figures = compute_figures(session_.mesh(), session_.document().tables().quarantine);
    return {figures.vertices, figures.edges, figures.faces, figures.rings};
  }

  void print_json(const LastState& last) {
    const Totals& now = last.totals;
    Record<edit_shape> json;
    json["file"] = files_.input.empty() ? Json() : Json(files_.input);
    json["output"] = or_null(written_);
    json["status"] = code_ == ExitCode::done && output_.losses.empty() ? "ok" : may_write() ? "warnings" : "error";
    json["vertices"] = now.vertices;
    json["edges"] = now.edges;
    json["faces"] = now.faces;
    json["rings"] = now.rings;
    json["hash"] = last.hash;
    json["applied"] = applied_;
    json["refused"] = refused_;
    std::vector<Message> messages = output_.losses;
    if (output_.failure) messages.push_back(output_.failure->message);
    if (!messages.empty()) json["messages"] = to_json(messages);
    console_.conclude(line_of(json), code_);
  }

  void print_text(const Totals& before, const LastState& last) {
    const Totals& now = last.totals;
    const auto count = [](std::string_view label, std::uint64_t then, std::uint64_t n) {
      const auto change = static_cast<std::int64_t>(n) - static_cast<std::int64_t>(then);
      return std::string(label) + " " + std::to_string(n) + " (" + (change > 0 ? "+" : "") + std::to_string(change) +
             ")";
    };
    const std::string a = std::to_string(applied_), r = std::to_string(refused_);
    const std::string counts = count("V", before.vertices, now.vertices) + "  " + count("E", before.edges, now.edges) +
                               "  " + count("F", before.faces, now.faces);
    console_.print(console_.text(Text{a + " done, " + r + " refused: ", a + " 件実行、" + r + " 件不可："}) + counts +
                   "\n");
    const ElementCounts& all = last.all;
    if (all.edges != now.edges || all.faces != now.faces)
      console_.print(console_.text(Text{"with wires and bridges, without faces set aside, as expect counts: ",
                                        "面のない稜線と橋を含み、隔離された面を含まない（expect の数え方）："}) +
                     "V " + std::to_string(all.vertices) + "  E " + std::to_string(all.edges) + "  F " +
                     std::to_string(all.faces) + "\n");
    console_.conclude(written_text(written_ ? &*written_ : nullptr, console_), code_);
  }

  EditFiles files_;
  const EditScript& script_;
  bool skip_refused_;
  const Console& console_;
  Session session_;
  bool stopped_ = false;
  bool failed_ = false;
  std::optional<std::string> written_;  // the last file
  std::vector<std::string> saved_;      // by `save`, in this order
  WrittenOutput output_;                // of -o
  ExitCode code_ = ExitCode::done;
  std::size_t applied_ = 0, refused_ = 0;
};

}  // namespace

ExitCode edit_command(const Arguments& arguments, const Console& given) {
  const bool starts_empty = arguments.has("--new");
  if (starts_empty != arguments.operands().empty())
    return given.fail(
        usage_failure("bad_value", {"edit begins with a FILE or, by --new, with an empty mesh.",
                                    "edit には FILE か、空のメッシュから始める --new のどちらかを指定します。"}));
  const std::string input = starts_empty ? std::string() : arguments.operands()[0];
  EditFiles files{input, {}, files_of_run(arguments, input)};
  if (const std::string* const output = arguments.value("-o")) files.output = *output;
  const std::string* const on_refuse = arguments.value("--on-refuse");
  if (on_refuse && *on_refuse != "skip")
    return given.fail(usage_failure("bad_value", {"--on-refuse is skip, not '" + *on_refuse + "'.",
                                                  "--on-refuse は skip です（「" + *on_refuse + "」は使えません）。"}));
  const std::string* const script_file = arguments.value("--script");
  const Result<EditScript> script = read_edit_script(script_file, arguments.values("--do"));
  if (!script && script.failure().exit_code == ExitCode::usage) return given.fail(script.failure());
  if (!script) return given.fail(script.failure(), *script_file);
  if (script_file) files.of_run.reads(*script_file, FileRole::script);
  std::vector<PlannedOutput> outputs;
  if (files.output) outputs.push_back({*files.output, FileRole::result});
  RunFiles planned = files.of_run;
  if (const auto fault = find_fault(*script, input, outputs, planned)) {
    given.show(fault->message, fault->message.line ? script->place() : input);
    return given.end(given.json ? line_of(error_object(fault->message, input)) : std::string(), fault->exit_code);
  }
  Console console = given;
  console.leaves_stdout = planned.uses_stdout();
  Result<std::unique_ptr<Document>> document =
      starts_empty ? Result<std::unique_ptr<Document>>(std::make_unique<Document>()) : Document::open(files.input);
  if (!document) return console.fail(document.failure(), files.input);
  for (const Message& message : (*document)->file().messages) console.show(message, files.input);
  return EditRun(std::move(*document), files, *script, on_refuse != nullptr, arguments.has("--strict"), console).run();
}

}  // namespace ryosen::cli
