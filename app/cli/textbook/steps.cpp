// `steps`: what can be played step by step, one line each.
#include <algorithm>

#include "app/cli/columns.h"
#include "app/cli/contract/json.h"
#include "app/cli/contract/textbook.h"
#include "app/cli/outputs.h"
#include "app/cli/subcommand_table.h"
#include "app/editor/commands/fly.h"
#include "app/editor/preferences/view_switches.h"
#include "app/editor/session/session.h"
#include "app/editor/textbook/playing.h"
#include "app/ui/headless.h"
#include "ryosen/mesh/find_element.h"
#include "ryosen/mesh/names.h"
#include "ryosen/ops/all.h"

namespace ryosen::cli {

namespace {

// Of more steps only those are made that are asked for.
constexpr std::size_t most_printed = 100000;

Json to_json(const steps::Mark& mark) {
  Record<mark_shape> json;
  json["role"] = steps::row_of(mark.role).id;
  json["element"] = slot_name(mark.element);
  return std::move(json).json();
}

Json to_json(const steps::RowChange& row) {
  Record<row_shape> json;
  json["table"] = row.table;
  json["row"] = row.row;
  json["field"] = row.field;
  json["old"] = or_null(row.old_value);
  json["new"] = or_null(row.new_value);
  return std::move(json).json();
}

Json to_json(const steps::Source& source) {
  Record<step_source_shape> json;
  json["text"] = source.text;
  json["listing"] = cli::to_json(Text{std::string(source.listing_en), std::string(source.listing_ja)});
  json["line"] = source.line > 0 ? Json(source.line) : Json();
  return std::move(json).json();
}

Json to_json(const steps::Delta& delta) {
  Record<delta_shape> json;
  json["V"] = delta.v;
  json["E"] = delta.e;
  json["F"] = delta.f;
  json["B"] = or_null(delta.b);
  json["W"] = delta.w;
  json["I"] = delta.i;
  json["H"] = delta.h;
  json["S"] = delta.s;
  json["G"] = or_null(delta.g);
  return std::move(json).json();
}

// The number of the curve behind a step.
std::optional<std::uint32_t> count_at(const steps::Sequence& sequence, std::size_t i) {
  const std::optional<steps::Curve> curve = sequence.curve();
  return curve && i <= curve->values.size() ? std::optional(curve->values[i - 1]) : std::nullopt;
}

std::string step_line(const steps::Step& step, std::size_t at, std::size_t of,
                      const std::optional<std::uint32_t>& count) {
  Record<step_shape> json;
  json["at"] = at;
  json["of"] = of;
  json["caption"] = cli::to_json(step.caption);
  json["marks"] = array_of(step.marks, [](const steps::Mark& mark) { return to_json(mark); });
  json["rows"] = array_of(step.rows, [](const steps::RowChange& row) { return to_json(row); });
  if (count) json["count"] = *count;
  json["source"] = step.source ? to_json(*step.source) : Json();
  if (step.delta) json["delta"] = to_json(*step.delta);
  return line_of(json);
}

std::string step_text(const steps::Step& step, std::size_t at, std::size_t of, const Console& console) {
  std::string text = std::to_string(at) + "/" + std::to_string(of) + "  " + console.text(step.caption);
  if (step.source) {
    text.append("  [").append(step.source->text).append(", ");
    text.append(console.text(step.source->listing_en, step.source->listing_ja));
    if (step.source->line > 0) text += ":" + std::to_string(step.source->line);
    text += "]";
  }
  text += "\n";
  Columns table;
  const std::string none(console.text("none", "なし"));
  for (const steps::RowChange& row : step.rows) {
    const std::string is = row.new_value.value_or(none);
    table.add({row.table, row.row, row.field,
               row.old_value == row.new_value ? is : row.old_value.value_or(none) + " -> " + is});
  }
  return text + table.text();
}

// What stands in front of the file.
std::vector<std::string> what_words(const std::vector<std::string>& operands) {
  std::vector<std::string> words;
  for (const std::string_view word : split_words(operands[0])) words.emplace_back(word);
  words.insert(words.end(), operands.begin() + 1, operands.end());
  return words;
}

// The words that call what is played, and the file behind them; none where an empty mesh will do.
struct PlayCall {
  std::vector<std::string> words;
  std::optional<std::string> file;
};

Result<PlayCall> wanted_play(const Arguments& arguments) {
  PlayCall call{what_words(arguments.operands()), {}};
  const auto row = find_played(call.words.empty() ? std::string_view() : call.words[0]);
  if (!row) return row.failure();
  const std::size_t words_without_file = (*row)->plays_script ? 2 : 0;
  if (call.words.size() < 2 && !(*row)->plays_script)
    return usage_failure("usage", {"The FILE is missing: steps " + steps::call_of(**row) + " FILE.",
                                   "FILE がありません：steps " + steps::call_of(**row) + " FILE。"});
  if (call.words.size() == words_without_file) return call;
  if ((*row)->plays_script && call.words.size() < 2) return call;
  call.file = call.words.back();
  call.words.pop_back();
  return call;
}

Result<std::size_t> wanted_step(const std::string& word, std::size_t size) {
  if (const auto number = whole_number(word, 1, size)) return std::size_t{*number};
  if (size == 0)
    return usage_failure("bad_value",
                         {"There is no step that --at could name.", "--at で指定できる手順がありません。"});
  const std::string n = std::to_string(size);
  return usage_failure("bad_value", {"--at takes the number of a step, from 1 to " + n + " here.",
                                     "--at は手順の番号です（ここでは 1 から " + n + "）。"});
}

// The view of the editor on the step, with its marks and caption.
std::optional<Failure> draw_step(std::unique_ptr<Document> document, const std::vector<std::string>& words,
                                 std::size_t at, std::size_t numbers, const std::string& path, const Console& console) {
  const auto headless = Headless::make({.size = {1280, 720}});
  if (!headless) return headless.failure();
  Session session(std::move(document));
  session.preferences.language = console.language;
  (*headless)->place_view(session);
  find_view_switch("numbers")->set(session, numbers);
  const Outcome begun = begin_playing(session.document(), session.view, session.framing, session.shown, words);
  if (!begun.done()) return make_failure(begun.exit_code, code_of(begun), begun.sentence);
  session.shown.go_to_step(at);
  if (const steps::Step* const step = steps_player(session.shown)->step(); step && !step->marks.empty())
    if (const Element about = step->marks[0].element; is_alive(session.mesh(), about))
      keep_in_sight(session.findings(), session.view, session.framing, about);
  const Status written = write_png((*headless)->picture(session), path);
  return written ? std::nullopt : std::optional(written.failure());
}

// Why a script ends early, as `edit` says it.
Failure failure_of(steps::Sequence& sequence) {
  const steps::Stop& stop = *sequence.stop();
  Text sentence = stop.sentence;
  std::vector<std::string_view> rules;
  for (const Reason& reason : stop.reasons) rules.push_back(text_of(reason.rule).id);
  rules.erase(std::unique(rules.begin(), rules.end()), rules.end());
  if (!rules.empty()) sentence += Text{":", "："};
  for (const Text& each : describe_first(sequence.mesh_at(sequence.size()), stop.reasons))
    sentence += Text{" " + each.en, each.ja};
  std::string names;
  for (const std::string_view rule : rules) names.append(names.empty() ? " [" : ", ").append(rule);
  if (!names.empty()) sentence += Text{names + "]", names + "]"};
  return make_failure(stop.exit_code, stop.exit_code == ExitCode::refused ? Code("refused") : Code("command_failed"),
                      std::move(sentence));
}

// Whose numbers stand in the picture: the value of the switch of the view.
Result<std::size_t> wanted_numbers(const Arguments& arguments) {
  const std::string* const word = arguments.value("--numbers");
  if (!word) return std::size_t{0};
  const ViewSwitch& row = *find_view_switch("numbers");
  if (const auto value = find_value(row, *word)) return *value;
  return usage_failure("bad_value", {"--numbers is one of " + ids_of(row.values) + ", not '" + *word + "'.",
                                     "--numbers は " + ids_of(row.values) + " のいずれかです（" + *word + "）。"});
}

ExitCode print_steps(const Arguments& arguments, const PlayCall& call, std::unique_ptr<Document> document,
                     const Console& console) {
  const Result<std::unique_ptr<steps::Sequence>> played = make_played(*document, call.words);
  if (!played) return console.fail(played.failure(), call.file.value_or(""));
  steps::Sequence& sequence = **played;
  const Result<std::size_t> numbers = wanted_numbers(arguments);
  if (!numbers) return console.fail(numbers.failure());
  std::size_t first = 1, last = sequence.size();
  if (const std::string* const at = arguments.value("--at")) {
    const Result<std::size_t> number = wanted_step(*at, sequence.size());
    if (!number) return console.fail(number.failure());
    first = last = *number;
  }
  if (sequence.size() > most_printed && !arguments.has("--at")) {
    const std::string n = std::to_string(sequence.size());
    return console.fail(make_failure(ExitCode::refused, "refused",
                                     {"There are " + n + " steps; --at N makes one of them.",
                                      "手順が " + n + " 個あります。--at N で一つを指定してください。"}),
                        call.file.value_or(""));
  }
  if (const Text remark = sequence.remark(); !remark.en.empty()) console.note(remark);
  for (std::size_t i = first; i <= last; ++i) {
    const steps::Step step = sequence.at(i);
    console.print(console.json ? step_line(step, i, sequence.size(), count_at(sequence, i))
                               : step_text(step, i, sequence.size(), console));
  }
  if (const std::string* const path = arguments.value("-o"))
    if (const auto failure = draw_step(std::move(document), call.words, last, *numbers, *path, console))
      return console.fail(*failure);
  if (sequence.stop() && last == sequence.size()) return console.fail(failure_of(sequence), call.words.back());
  return console.end("");
}

}  // namespace

ExitCode steps_command(const Arguments& arguments, const Console& console) {
  const Result<PlayCall> call = wanted_play(arguments);
  if (!call) return console.fail(call.failure());
  if (const std::string* const path = arguments.value("-o"))
    if (const Status may = files_of_run(arguments, call->file.value_or("")).may_write(*path, FileRole::picture); !may)
      return console.fail(may.failure());
  if (!call->file) return print_steps(arguments, *call, std::make_unique<Document>(), console);
  Result<std::unique_ptr<Document>> document = Document::open(*call->file);
  if (!document) return console.fail(document.failure(), *call->file);
  for (const Message& message : (*document)->file().messages) console.show(message, *call->file);
  return print_steps(arguments, *call, std::move(document).value(), console);
}

}  // namespace ryosen::cli
