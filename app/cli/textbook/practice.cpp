// `practice`: asks about the structure of a mesh, and judges an answer.
#include "app/editor/textbook/practice.h"

#include "app/cli/contract/json.h"
#include "app/cli/contract/textbook.h"
#include "app/cli/subcommand_table.h"
#include "app/editor/textbook/figures.h"
#include "ryosen/base/rows.h"
#include "ryosen/indexed/from_indexed.h"
#include "ryosen/io/formats.h"
#include "ryosen/mesh/names.h"

namespace ryosen::cli {

namespace {

// The mesh that is asked about, and what it is called.
struct Asked {
  std::string name;
  Mesh mesh;
};

// 1 where it is not given.
Result<std::uint64_t> number_of(const Arguments& arguments, std::string_view flag, std::uint64_t least,
                                std::uint64_t most) {
  const std::string* const words = arguments.value(flag);
  if (!words) return std::uint64_t{1};
  if (const auto number = whole_number(*words, least, most)) return *number;
  const std::string name(flag), from = std::to_string(least), to = std::to_string(most);
  return usage_failure("bad_value", {name + " takes a whole number from " + from + " to " + to + ".",
                                     name + " は " + from + " から " + to + " までの整数です。"});
}

Failure unknown_kind(const std::string& id) {
  const std::string known = joined_ids(question_kinds(), ", ");
  return usage_failure("bad_value", {"There is no kind '" + id + "'; the kinds are " + known + ".",
                                     "問題の種類「" + id + "」はありません（" + known + "）。"});
}

Result<Mesh> mesh_at(const std::string& path, const Console& console) {
  Result<MeshFile> file = read_mesh_file(path);
  if (!file) return file.failure();
  for (const Message& message : file->messages) console.show(message, path);
  return from_indexed(std::move(file->mesh));
}

std::string json_line_of(const Asked& asked, std::uint64_t seed, const Question& question, const Solution& solution,
                         const std::string* given) {
  const auto null_if_empty = [](const std::string& text) { return text.empty() ? Json() : Json(text); };
  Record<practice_shape> json;
  json["seed"] = seed;
  json["kind"] = question_kinds()[static_cast<std::size_t>(question.kind)].id;
  json["mesh"] = asked.name;
  json["about"] = slot_name(question.about);
  json["form"] = null_if_empty(question.form);
  json["field"] = null_if_empty(question.field);
  json["command"] = null_if_empty(question.line);
  json["question"] = cli::to_json(question.asks);
  json["answers"] = solution.answers;
  json["why"] = cli::to_json(solution.why);
  json["witnesses"] = array_of(solution.witnesses, [](const Element& witness) { return slot_name(witness); });
  json["given"] = given ? Json(*given) : Json();
  json["right"] = given ? Json(is_right(asked.mesh, solution, *given)) : Json();
  return line_of(json);
}

std::string text_of(const Asked& asked, const Question& question, const Solution& solution, const std::string* given,
                    const Console& console) {
  std::string text = asked.name + ": " + console.text(question.asks) + "\n";
  if (!given) return text;
  const bool right = is_right(asked.mesh, solution, *given);
  if (right)
    text += console.text("  Right. ", "  正解です。");
  else
    text += "  " + console.text(verdict_on_wrong(solution)) + std::string(console.text(" ", ""));
  text += console.text(solution.why);
  for (std::size_t i = 0; i < solution.witnesses.size(); ++i)
    text += (i == 0 ? " (" : ", ") + slot_name(solution.witnesses[i]);
  return text + (solution.witnesses.empty() ? "\n" : ")\n");
}

}  // namespace

ExitCode practice_command(const Arguments& arguments, const Console& console) {
  const Result<std::uint64_t> seed = number_of(arguments, "--seed", 0, 1'000'000'000'000);
  if (!seed) return console.fail(seed.failure());
  const Result<std::uint64_t> count = number_of(arguments, "--count", 1, 100'000);
  if (!count) return console.fail(count.failure());
  const std::string* const kind_id = arguments.value("--kind");
  const QuestionKindRow* const wanted = kind_id ? find_question_kind(*kind_id) : nullptr;
  if (kind_id && !wanted) return console.fail(unknown_kind(*kind_id));
  const std::string* const given = arguments.value("--answer");
  Asked asked;
  const bool has_file = !arguments.operands().empty();
  if (has_file) {
    asked.name = arguments.operands()[0];
    Result<Mesh> mesh = mesh_at(asked.name, console);
    if (!mesh) return console.fail(mesh.failure(), asked.name);
    asked.mesh = std::move(mesh).value();
    if (asked.mesh.live().edges == 0 || asked.mesh.live().faces == 0)
      return console.fail(
          make_failure(ExitCode::refused, "refused",
                       {"There is nothing to ask about: it has no faces.", "面がないため出題できません。"}),
          asked.name);
  }
  bool all_right = true;
  for (std::uint64_t n = 0; n < *count; ++n) {
    const std::uint64_t each = *seed + n;
    if (!has_file) {
      const std::string_view figure = figure_to_ask_about(each);
      if (asked.name != figure) {
        Result<MeshFile> file = mesh_of_figure(*find_figure(figure));
        if (!file) return console.fail(file.failure());
        asked = {std::string(figure), from_indexed(std::move(file->mesh))};
      }
    }
    const QuestionKind kind = wanted ? wanted->kind : kind_of_seed(each);
    const Question question = make_question(asked.mesh, kind, each);
    const Solution solution = solve(asked.mesh, question);
    if (const Text doubt = given ? doubt_about(asked.mesh, solution, *given) : Text(); !doubt.en.empty())
      return console.fail(failure_of_name(NameError::ambiguous, doubt), asked.name);
    if (const Text fault = given ? why_no_answer(asked.mesh, question, solution, *given) : Text(); !fault.en.empty())
      return console.fail(usage_failure("bad_value", fault), asked.name);
    all_right &= !given || is_right(asked.mesh, solution, *given);
    console.print(console.json ? json_line_of(asked, each, question, solution, given)
                               : text_of(asked, question, solution, given, console));
  }
  const ExitCode code = all_right ? ExitCode::done : ExitCode::found_problems;
  return console.end("", code);
}

}  // namespace ryosen::cli
