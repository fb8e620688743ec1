// Algorithms as commands: each by its id, and `repair`, which knows them by what they solve.
#include <algorithm>
#include <new>

#include "app/editor/commands/command_functions.h"
#include "app/editor/commands/command_syntax.h"
#include "app/editor/commands/text/script.h"
#include "app/editor/commands/text/words.h"
#include "app/editor/document/repair_call.h"
#include "app/editor/session/selection.h"
#include "app/editor/session/session.h"
#include "app/editor/shown/levels.h"
#include "ryosen/algo/algorithm_table.h"

namespace ryosen {

namespace {

// The repair of a list or a single word, which fault_of_repair has let pass.
RepairCall call_of_repair(Words words) {
  if (is_list_of_repairs(words[0])) return read_repairs(words[0]).call;
  const AlgorithmRow& row = *find_algorithm(words[0]);
  return {{{&row, *read_values(row.parameters, words.subspan(1)).values}}, false};
}

Text fault_of(const ReadRepairs& read) {
  return *read.fault + (read.unknown.empty() ? Text() : did_you_mean(read.unknown, ids_of_repairs()));
}

// What is done is an entry of the history by now, and stays one where there is no memory to say more of it.
template <class SayMore>
void unless_memory_lacks(SayMore say_more) {
  try {
    say_more();
  } catch (const std::bad_alloc&) {
  }
}

// The repairs of a list, in rounds, as one entry of the history.
Outcome run_recipe(Document& document, Findings& findings, Frontend& frontend, const std::string& list) {
  const RepairCall call = read_repairs(list).call;
  for (const RecipeStep& step : call.steps)
    if (const ReadValues found = step.values.on(document.mesh()); !found.values)
      return failed(found.lacks_extent ? ExitCode::refused : ExitCode::usage, found.sentence);
  Outcome outcome;
  outcome.performed = "repair " + list;
  RecipeEvents events;
  if (frontend.on_progress)
    events.progress = [&](const RecipeStep& step, std::size_t, double share) {
      return frontend.on_progress((static_cast<double>(&step - call.steps.data()) + share) /
                                  static_cast<double>(call.steps.size()));
    };
  const BesideRepairs beside = document.beside_repairs();
  const auto result = document.run(call.steps, outcome.performed, events);
  if (!result) return cancelled();
  unless_memory_lacks([&] {
    RepairReport report = report_of(call, *result, document.mesh(), beside.input());
    outcome.sentence = told(report, document.mesh());
    findings.keep_report(std::move(report));
  });
  return outcome;
}

bool means_selection(std::string_view word) { return word == selection_word || word.ends_with("=selected"); }

// The word `selected` alone is the value of the first parameter: of elements, or none.
std::optional<Text> fault_of_selected(const AlgorithmRow& row, Words words) {
  const auto takes_elements = [](const ParameterRow& p) { return p.kind == ParameterKind::elements; };
  if (words.empty() || words[0] != "selected" || row.parameters.empty() || takes_elements(row.parameters[0])) return {};
  const auto elements = std::find_if(row.parameters.begin(), row.parameters.end(), takes_elements);
  if (elements == row.parameters.end())
    return Text{"it takes no elements, so that 'selected' means nothing", "要素を取らないため、selected は使えません"};
  const std::string whole = std::string(elements->id) + "=selected";
  return Text{"what is selected is given by its name, " + whole,
              "選択した要素は " + whole + " と名前をつけて指定します"};
}

std::vector<std::string> names_of_kept(const Selecting& selecting) {
  std::vector<std::string> names;
  for (const auto& [name, elements] : selecting.memory.kept) names.push_back(name);
  return names;
}

// Of those names the ones under which nothing is kept any more.
Text gone_text(const Selecting& selecting, const std::vector<std::string>& names) {
  std::string gone, gone_ja;
  for (const std::string& name : names) {
    if (selecting.memory.kept.contains(name)) continue;
    gone += (gone.empty() ? "'" : ", '") + name + "'";
    gone_ja += "「" + name + "」";
  }
  if (gone.empty()) return {};
  return {
      " What was kept as " + gone + " is gone, since it cannot be told what has become of it; undo brings it back.",
      "取っておいた選択" + gone_ja + "は、対応する要素がわからなくなったため破棄しました（元に戻すと復活します）。"};
}

struct ReadCall {
  std::optional<AlgorithmCall> call;
  Outcome fault;  // where there is none
};

// The call that the words say; what is selected keeps that word.
ReadCall read_call(const AlgorithmRow& row, Words words, bool is_called_repair) {
  if (const auto fault = fault_of_selected(row, words)) return {{}, usage_error(behind(row.id, *fault))};
  const std::vector<std::string> selected{std::string(selection_word)};
  ReadValues given = read_values(row.parameters, words, &selected);
  if (!given.values) return {{}, usage_error(behind(row.id, given.sentence))};
  const bool has_unnamed_value = !words.empty() && words[0].find('=') == std::string_view::npos;
  return {AlgorithmCall{&row, *std::move(given.values), is_called_repair, has_unnamed_value}, {}};
}

Outcome nothing_selected(const AlgorithmRow& row) {
  return failed(ExitCode::refused, behind(row.id, {"nothing is selected", "選択がありません"}));
}

Outcome run_words(Session& session, const AlgorithmRow& row, Words words, bool is_called_repair) {
  const bool lacks_selection =
      session.selecting.selection.empty() && std::any_of(words.begin(), words.end(), means_selection);
  if (lacks_selection && !fault_of_selected(row, words)) return nothing_selected(row);
  const ReadCall read = read_call(row, words, is_called_repair);
  return read.call ? run_algorithm(session, *read.call, read.call->line()) : read.fault;
}

}  // namespace

Outcome run_algorithm(Session& session, AlgorithmCall call, std::string line) {
  const AlgorithmRow& row = *call.row;
  const std::string id(row.id);
  const auto called = [](const ParameterRow& parameter) { return std::string(parameter.id); };
  if (const auto fault = call.values.fault_of_missing(called)) return usage_error(behind(id, *fault));
  const std::vector<std::string> selected{std::string(selection_word)};
  for (std::size_t i = 0; i < row.parameters.size(); ++i) {
    const ParameterValue* const value = call.values.at(i);
    if (!value || value->names != selected) continue;
    if (session.selecting.selection.empty()) return nothing_selected(row);
    call.values.set_elements(row.parameters[i].id, session.selecting.selection, session.selecting.selected_names());
    line = call.line();
  }
  const ReadValues found = call.values.on(session.mesh());
  if (found.lacks_extent) return failed(ExitCode::refused, behind(id, found.sentence));
  if (!found.values) return no_element(session.document(), id + " " + found.name, found.error, found.sentence);
  Outcome outcome;
  outcome.performed = std::move(line);
  const FirstSlots before(session.mesh());
  const bool was_empty = session.mesh().live() == ElementCounts();
  // Who wants it later asks for it (find_left_edges).
  const bool wants_account = row.accounts_for_edges && session.layout.is_shown(panel_opened_by(PanelOpener::levelled));
  const std::vector<std::string> names_before = names_of_kept(session.selecting);
  const bool wants_descent = !session.selecting.selection.empty() || !names_before.empty();
  auto result = session.document().run(row, *found.values, outcome.performed, session.frontend.on_progress,
                                       {wants_account, wants_descent});
  if (!result) return cancelled();
  if (result->fault) return usage_error(id + ": " + result->fault->en, id + "：" + result->fault->ja);
  if (result->refused)
    return failed(ExitCode::refused, {id + ": " + result->refused->en, id + "：" + result->refused->ja});
  if (was_empty && result->changed > 0) session.framing.frame_all();  // nobody could have looked at it before
  unless_memory_lacks([&] {
    if (row.selects_added && result->changed > 0) session.selecting.selection = before.added_to(session.mesh());
    if (result->goal_report && !result->goal_report->rules.empty())
      session.findings().keep_left_edges({session.document().serial(), session.document().revision(),
                                          std::move(result->goal_report->rules),
                                          std::move(result->goal_report->remaining)});
    if (!row.is_repair()) return;
    const BesideRepairs beside = session.document().beside_repairs();
    session.findings().keep_report(report_of({{{&row, call.values}}, false}, *result, session.mesh(), beside.input()));
  });
  outcome.sentence = std::move(result->text);
  unless_memory_lacks([&] { outcome.sentence = outcome.sentence + gone_text(session.selecting, names_before); });
  return outcome;
}

CommandRow row_of(const AlgorithmRow& algorithm) {
  const auto fault = [&algorithm](Words given, const std::string&) -> std::optional<Text> {
    if (auto alone = fault_of_selected(algorithm, given)) return behind(algorithm.id, *alone);
    const std::vector<std::string> whatever_is_selected;  // the words are checked, not the elements
    ReadValues read = read_values(algorithm.parameters, given, &whatever_is_selected);
    return read.values ? std::nullopt : std::optional(behind(algorithm.id, read.sentence));
  };
  return {.id = algorithm.id,
          .syntax = syntax_of(algorithm.parameters),
          .help_en = algorithm.help_en,
          .help_ja = algorithm.help_ja,
          .effect = Effect::edits,
          .run = [&algorithm](Session& session, Words words,
                              std::string_view) { return run_words(session, algorithm, words, false); },
          .is_long = true,
          .fault = fault};
}

std::optional<Text> fault_of_repair(Words words, const std::string& line) {
  if (words.empty()) return wrong_arguments("repair").sentence;
  const AlgorithmRow* const row = find_algorithm(words[0]);
  if (row && row->is_repair()) return row_of(*row).fault(words.subspan(1), line);
  const ReadRepairs read = read_repairs(words[0]);
  if (read.fault) return fault_of(read);
  return fault_unless(words.size() == 1, "repair");
}

Outcome run_repair(Session& session, Words words, std::string_view) {
  if (const auto fault = fault_of_repair(words, {})) return usage_error(fault->en, fault->ja);
  if (is_list_of_repairs(words[0]))
    return run_recipe(session.document(), session.findings(), session.frontend, std::string(words[0]));
  const AlgorithmRow& row = *find_algorithm(words[0]);
  return run_words(session, row, words.subspan(1), true);
}

std::optional<Text> fault_of_would(Words words, const std::string& line) {
  if (words.empty() || words[0] != "repair") return wrong_arguments("would").sentence;
  return fault_of_repair(words.subspan(1), line);
}

Outcome run_would(const Document& document, const Frontend& frontend, Words words, std::string_view) {
  if (const auto fault = fault_of_would(words, {})) return usage_error(*fault);
  const RepairCall call = call_of_repair(words.subspan(1));
  const BesideRepairs beside = document.beside_repairs();
  const auto report = try_repair(document.mesh(), call, beside.input(), frontend.on_progress);
  if (!report) return cancelled();
  if (report->fault) return usage_error(*report->fault);
  return done_with(Text{"Tried, not done: ", "試しました（変更はしていません）："} + told(*report, document.mesh()));
}

const RepairReport* tried(const Document& document, RepairTrials& trials, const std::string& line) {
  const std::vector<std::string_view> words = split_words(line);
  const RepairCall call = call_of_repair(Words(words).subspan(1));
  return trials.of(document, line, call, is_costly_to_try(document.mesh()));
}

}  // namespace ryosen
