// `repair`: takes whole kinds of problems away, and says what it did and what is left.
#include <algorithm>
#include <map>
#include <memory>

#include "app/cli/check_report.h"
#include "app/cli/contract/record.h"
#include "app/cli/contract/repair.h"
#include "app/cli/did_you_mean.h"
#include "app/cli/edit_script.h"
#include "app/cli/interrupt.h"
#include "app/cli/subcommands.h"
#include "app/cli/write_output.h"
#include "app/editor/document.h"

namespace ryosen::cli {

namespace {

// One word of --kinds.
std::optional<Failure> add_calls(const std::string& word, std::vector<RepairCall>& calls) {
  if (word == "default") {
    for (const RepairRow& row : repair_table())
      if (row.keeps_geometry) calls.push_back({&row, std::nullopt});
    return std::nullopt;
  }
  const std::size_t equals = std::min(word.find('='), word.size());
  const std::string id = word.substr(0, equals);
  std::optional<std::string_view> number;
  if (equals < word.size()) number = std::string_view(word).substr(equals + 1);
  const ParsedRepair parsed = parse_repair(id, number);
  if (parsed.call.row) {
    calls.push_back(parsed.call);
    return std::nullopt;
  }
  std::vector<std::string> known{"default"};
  for (const RepairRow& row : repair_table()) known.emplace_back(row.id);
  Text hint = did_you_mean(id, known);
  if (const RepairRow* const row = find_repair(id); row && !row->syntax.empty()) {
    const std::string form = id + "=" + std::string(row->syntax);
    hint = {" Write " + form + ".", "（書式：" + form + "）"};
  }
  return usage_failure("bad_value", {"--kinds: " + parsed.sentence.en + "." + hint.en,
                                     "--kinds：" + parsed.sentence.ja + "。" + hint.ja});
}

// Each repair once, in the order of the table; of two calls the later counts.
Result<std::vector<RepairCall>> read_kinds(const std::string& list) {
  std::vector<RepairCall> calls;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    if (auto failure = add_calls(list.substr(begin, end - begin), calls)) return std::move(*failure);
    begin = end + 1;
  }
  std::map<const RepairRow*, RepairCall> by_row;  // rows lie in one array, in their order
  for (const RepairCall& call : calls) by_row[call.row] = call;
  calls.clear();
  for (const auto& [row, call] : by_row) calls.push_back(call);
  return calls;
}

struct Done {
  RepairCall call;
  RepairResult result;
};

std::string name_of(const RepairCall& call) {
  return std::string(call.row->id) + (call.number ? "=" + format_double(*call.number) : "");
}

class RepairRun {
 public:
  RepairRun(Document& document, EditFiles files, const Console& console)
      : document_(document), files_(std::move(files)), console_(console) {}

  ExitCode run(const std::vector<RepairCall>& calls) {
    if (!repair(calls)) return cancel();
    // What is left is named as in the file that is written.
    after_ = check_mesh(document_.contents(), files_.output.value_or(files_.input));
    const bool has_problem = std::any_of(after_.problems.begin(), after_.problems.end(), [](const NamedProblem& p) {
      return p.problem.row().severity == ProblemSeverity::problem;
    });
    code_ = has_problem ? ExitCode::found_problems : ExitCode::done;
    if (files_.output) write();
    console_.json ? print_json() : print_text();
    return code_;
  }

 private:
  // False when it was interrupted.
  bool repair(const std::vector<RepairCall>& calls) {
    const Interrupt interrupt;
    for (const RepairCall& call : calls) {
      std::optional<RepairResult> result = document_.repair(call, report_on(console_, name_of(call)));
      if (!result || Interrupt::was_asked()) return false;
      done_.push_back({call, std::move(*result)});
      if (!console_.json)
        console_.print_now(name_of(call) + console_.text(": ", "：").data() + console_.text(done_.back().result.text) +
                           "\n");
    }
    return true;
  }

  ExitCode cancel() const {
    Failure failure{ExitCode::cancelled, {}};
    failure.message.code = "cancelled";
    failure.message.text = {"Cancelled; nothing is written.", "中止しました。何も書き出していません。"};
    return console_.fail(failure, files_.input);
  }

  void write() {
    output_ = write_output(document_, *files_.output, false, console_);
    if (output_.failure) code_ = output_.failure->exit_code;
  }

  void print_text() const {
    console_.print(after_.problems.empty() ? console_.text("left: nothing\n", "残り：なし\n")
                                           : console_.text("left:\n", "残り：\n"));
    for (const NamedProblem& problem : after_.problems) console_.print(to_text(problem, console_));
    if (output_.is_there)
      console_.print(console_.text(Text{"written: ", "書き出し："}) + *files_.output + "\n");
    else
      console_.print(console_.text("nothing written\n", "書き出しなし\n"));
  }

  void print_json() const {
    Record<repair_shape> json;
    json["file"] = files_.input;
    json["output"] = output_.is_there ? Json(*files_.output) : Json();
    json["status"] = output_.failure ? "error" : code_ == ExitCode::done && output_.losses.empty() ? "ok" : "warnings";
    json["repairs"] = Json::array();
    for (const Done& done : done_) {
      Record<repair_step_shape> repair;
      repair["kind"] = done.call.row->id;
      repair["number"] = done.call.number ? Json(*done.call.number) : Json();
      repair["changed"] = done.result.changed;
      repair["left"] = done.result.left;
      repair["solves"] = Json::array();
      for (ProblemKind kind : done.call.row->solves) repair["solves"].push_back(row_of(kind).id);
      repair["en"] = done.result.text.en;
      repair["ja"] = done.result.text.ja;
      json["repairs"].push_back(std::move(repair).json());
    }
    json["vertices"] = after_.figures.vertices;
    json["edges"] = after_.figures.edges;
    json["faces"] = after_.figures.faces;
    json["hash"] = after_.hash;
    json["problems"] = Json::array();
    for (const NamedProblem& problem : after_.problems) json["problems"].push_back(cli::to_json(problem));
    std::vector<Message> messages = output_.failure ? std::vector{output_.failure->message} : document_.file().messages;
    messages.insert(messages.end(), output_.losses.begin(), output_.losses.end());
    json["messages"] = cli::to_json(messages);
    console_.print(line_of(json));
  }

  Document& document_;
  EditFiles files_;
  const Console& console_;
  std::vector<Done> done_;
  CheckReport after_;
  WrittenOutput output_;
  ExitCode code_ = ExitCode::done;
};

}  // namespace

ExitCode repair_command(const Arguments& arguments, const Console& console) {
  EditFiles files{arguments.operands()[0], {}, arguments.has("--overwrite")};
  if (const std::string* const output = arguments.value("-o")) files.output = *output;
  const std::string* const kinds = arguments.value("--kinds");
  const Result<std::vector<RepairCall>> calls = read_kinds(kinds ? *kinds : "default");
  if (!calls) return console.fail(calls.failure());
  if (const auto fault = find_fault({}, files)) return console.fail(*fault, files.input);
  const Result<std::unique_ptr<Document>> document = Document::open(files.input);
  if (!document) return console.fail(document.failure(), files.input);
  for (const Message& message : (*document)->file().messages) console.show(message, files.input);
  return RepairRun(**document, files, console).run(*calls);
}

}  // namespace ryosen::cli
