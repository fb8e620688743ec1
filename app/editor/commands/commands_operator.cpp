// Operators as commands, on named elements or on the selection; and `either`, which is told several commands.
#include <algorithm>
#include <optional>

#include "app/editor/commands/command_functions.h"
#include "app/editor/commands/command_syntax.h"
#include "app/editor/commands/text/words.h"
#include "app/editor/session/operator_selection.h"
#include "app/editor/session/session.h"
#include "ryosen/base/count_text.h"
#include "ryosen/base/index_set.h"
#include "ryosen/base/split_list.h"
#include "ryosen/mesh/names.h"
#include "ryosen/ops/all.h"
#include "ryosen/ops/parameters/op_line.h"

namespace ryosen {

namespace {

bool is_on_selection(Words arguments) { return !arguments.empty() && arguments[0] == selection_word; }

Outcome apply(Document& document, const Frontend& frontend, const AnyOp& op) {
  Outcome outcome = document.apply(op, frontend.is_strict);
  if (outcome.done()) outcome.performed = document.history().back().command;
  return outcome;
}

Outcome apply_words(Document& document, const Frontend& frontend, const std::string& called, Words arguments,
                    std::string_view whole) {
  const ParsedOp parsed = parse_op(document.mesh(), called, op_arguments(arguments));
  if (!parsed.op) return no_element(document, called + std::string(whole), parsed.error, parsed.sentence);
  return apply(document, frontend, *parsed.op);
}

std::string line_of(const Mesh& mesh, const OpInfo& op, std::span<const OpArgument> arguments) {
  std::string line(op.id);
  for (const OpArgument& argument : arguments) line += " " + print_argument(mesh, argument);
  return line;
}

// What one element of a selection may be: "a vertex or an edge"; empty where none alone is enough.
Text kinds_taken(const OpInfo& op) {
  constexpr struct {
    Element::Kind kind;
    const char *one, *two, *ja, *two_ja;
  } words[] = {{Element::Kind::vertex, "a vertex", "two vertices or more", "頂点", "二つ以上の頂点"},
               {Element::Kind::edge, "an edge", "two edges or more", "稜線", "二本以上の稜線"},
               {Element::Kind::face, "a face", "two faces or more", "面", "二つ以上の面"}};
  Text told;
  for (const auto& [kind, one, two, ja, two_ja] : words) {
    if (!takes(op, kind, {})) continue;
    if (!told.en.empty()) told = told + Text{" or ", "または"};
    told = told + (least_taken(op) == 2 ? Text{two, two_ja} : Text{one, ja});
  }
  if (op.in_place_of)
    told = told + Text{", or ", "、または"} + Text{std::string(op.in_place_of->en), std::string(op.in_place_of->ja)};
  return told;
}

// The elements that a line takes, in words: "two vertices in order; then a face, where several have them". The syntax
// where it takes something else.
Text in_words(const OpLine& line) {
  struct Kind {
    const char *one, *many, *ja, *counter_ja;
    int wanted = 0;
  };
  Kind vertices{"vertex", "vertices", "頂点", "個"}, edges{"edge", "edges", "稜線", "本"},
      faces{"face", "faces", "面", "個"};
  const std::string syntax = syntax_of(line);
  bool may_be_more = false, may_name_face = false, may_name_sides = false;
  if (line.all_lists().size() != 1) return {syntax, syntax};
  for (const OpParameter& parameter : line.lists[0]) {
    const OpValueKind kind = parameter.values[0].kind;
    may_be_more = may_be_more || parameter.is_list();
    if (parameter.is_optional()) {
      may_name_face = may_name_face || kind == OpValueKind::face;
      may_name_sides = may_name_sides || kind == OpValueKind::edge;
    } else if (!is_element(kind) || parameter.count() > 1) {
      return {syntax, syntax};
    } else {
      ++(kind == OpValueKind::vertex ? vertices : kind == OpValueKind::edge ? edges : faces).wanted;
    }
  }
  constexpr const char* numbers[] = {"no", "one", "two", "three"};
  const Kind& kind = faces.wanted > 0 ? faces : edges.wanted > 0 ? edges : vertices;
  const int n = kind.wanted;
  if (n < 1 || n > 3 || vertices.wanted + edges.wanted + faces.wanted != n) return {syntax, syntax};
  Text told{std::string(numbers[n]) + " " + (n == 1 ? kind.one : kind.many),
            std::string(kind.ja) + "を " + std::to_string(n) + " " + kind.counter_ja};
  if (may_be_more) told = told + Text{" or more", "以上"};
  if (n > 1) told = told + Text{", in order", "、この順に"};
  if (may_name_face)
    told = told + Text{"; then a face, where several have them", "（面が一つに決まらなければ続けて面）"};
  if (may_name_sides)
    told = told + Text{"; then the halfedges that end there, where several do",
                       "（場所が一つに決まらなければ続けて終点での半稜線）"};
  return told;
}

Outcome nothing_selected(const OpInfo& op) {
  const std::string en(op.name_en), ja(op.name_ja);
  const Text kinds = op.on_selection == OnSelection::all ? in_words(op.line) : kinds_taken(op);
  return failed(ExitCode::refused, {en + ": nothing is selected that it works on; select " + kinds.en,
                                    ja + "：対象となる要素が選択されていません。選択するもの：" + kinds.ja});
}

Outcome does_not_fit(const OpInfo& op) {
  const std::string en(op.name_en), ja(op.name_ja);
  const Text wanted = in_words(op.line);
  return failed(ExitCode::refused, {en + ": what is selected does not fit; it takes " + wanted.en,
                                    ja + "：選択された要素が合いません。必要なもの：" + wanted.ja});
}

// "12 done. 3 refused: RULE. 2 were deleted before their turn.", or "One face was made."
Text told(const OpInfo& op, const EachResult& result) {
  Text text{"Nothing was done.", "何も実行していません。"};
  if (result.done > 0 && !op.made.en_one.empty())
    text = count_text(result.calls, op.made.en_one, op.made.en_many, op.made.ja);
  else if (result.done > 0)
    text = count_text(result.done, "One done.", "# done.", "# 件を実行しました。");
  for (const EachResult::Refused& refused : result.refused) {
    const RuleText& rule = text_of(refused.rule);
    const Text count = count_text(refused.elements.size(), "One refused", "# refused", "# 件は実行できません");
    text.en += " " + count.en + ": " + std::string(rule.en);
    text.ja += count.ja + "：" + std::string(rule.ja);
  }
  if (result.ends > 0) {
    const Text ends = count_text(result.ends, "One vertex that was left with two edges went too.",
                                 "# vertices that were left with two edges went too.",
                                 "稜線が二本になった頂点 # 個も取り除きました。");
    text.en += " " + ends.en;
    text.ja += ends.ja;
  }
  if (result.gone > 0) {
    const Text gone = count_text(result.gone, "One was deleted before its turn.", "# were deleted before their turn.",
                                 "# 件は順番の前に削除されました。");
    text.en += " " + gone.en;
    text.ja += gone.ja;
  }
  return text;
}

// What was refused stays selected, and so does what is of another kind, or else all that lives on.
void select_refused(const Mesh& mesh, Selecting& selecting, const EachResult& result) {
  if (result.refused.empty()) return;
  Elements left = result.others;
  for (const EachResult::Refused& refused : result.refused)
    left.insert(left.end(), refused.elements.begin(), refused.elements.end());
  drop_lost(left, mesh, false);
  selecting.selection = std::move(left);
}

// The selection without those that were refused: the same is done with it whatever is refused for.
std::string line_without_refused(const Elements& selection, const EachResult& result) {
  ElementSet refused;
  for (const EachResult::Refused& each : result.refused)
    for (const Element& e : each.elements) refused.insert(e);
  Elements left;
  for (const Element& e : selection)
    if (!refused.contains(e)) left.push_back(e);
  return "select" + slot_ranges(left);
}

Outcome apply_to_each(Document& document, Findings& findings, Selecting& selecting, const Frontend& frontend,
                      const OpInfo& op, Words words) {
  const Elements selected = worked_on(findings, selecting, op, words.subspan(1));
  Outcome outcome;
  outcome.performed = line_of(document.mesh(), op, op_arguments(words));
  outcome.selecting = selected == selecting.selection ? selecting.select_line() : "select" + slot_ranges(selected);
  const auto result = document.apply_to_each(op, selected, words.subspan(1), outcome.performed, frontend.is_strict,
                                             frontend.on_progress);
  if (!result) return cancelled();
  if (result->error != NameError::none) return usage_error(behind(op.id, result->sentence));
  if (result->done + result->gone + result->refusals() == 0) return nothing_selected(op);
  // A script that is not strict would do what was refused for a warning.
  if (frontend.is_strict && result->refusals() > 0) outcome.selecting = line_without_refused(selected, *result);
  outcome.sentence = told(op, *result);
  for (const EachResult::Refused& refused : result->refused) {
    outcome.reasons.push_back({refused.rule, refused.elements});
    drop_lost(outcome.reasons.back().witnesses, document.mesh(), false);  // a later call may have deleted some
  }
  if (result->done == 0) {
    outcome.kind = Outcome::Kind::refused;
    outcome.exit_code = ExitCode::refused;
    outcome.performed.clear();
    return outcome;
  }
  select_refused(document.mesh(), selecting, *result);
  return outcome;
}

Outcome apply_to_all(Document& document, Findings& findings, const Selecting& selecting, const Frontend& frontend,
                     const OpInfo& op, Words words) {
  if (selecting.selection.empty()) return nothing_selected(op);
  const Elements selected = worked_on(findings, selecting, op, words.subspan(1));
  const Elements taken = elements_taken(op, selected, words.subspan(1));
  const std::vector<OpArgument> arguments = op_arguments(taken, words.subspan(1));
  if (fault_of_arguments(op.id, arguments)) return does_not_fit(op);
  const ParsedOp parsed = parse_op(document.mesh(), op.id, arguments);
  if (parsed.op) return apply(document, frontend, *parsed.op);
  return no_element(document, line_of(document.mesh(), op, arguments), parsed.error, parsed.sentence);
}

Outcome apply_to_selection(Document& document, Findings& findings, Selecting& selecting, const Frontend& frontend,
                           const OpInfo& op, Words words) {
  if (op.on_selection == OnSelection::all) return apply_to_all(document, findings, selecting, frontend, op, words);
  return apply_to_each(document, findings, selecting, frontend, op, words);
}

std::optional<Text> fault_on_selection(const OpInfo& op, Words words) {
  if (op.on_selection == OnSelection::none) return fault_of_arguments(op.id, op_arguments(words));
  for (const auto kind : {Element::Kind::vertex, Element::Kind::edge, Element::Kind::face})
    if (op.on_selection == OnSelection::all || takes(op, kind, words.subspan(1))) return std::nullopt;
  return not_of_syntax(words.back(), std::string(selection_word) + " | " + syntax_of(op.line));
}

}  // namespace

std::vector<std::string> alternatives(std::string_view whole) {
  std::vector<std::string> lines;
  for (const std::string_view line : split_list(whole, '|')) lines.emplace_back(without_blanks(line));
  return lines;
}

CommandRow row_of(const OpInfo& op, std::string_view called) {
  const std::string word(called);
  const auto run = [word, &op](Session& session, Words arguments, std::string_view whole) {
    if (!is_on_selection(arguments)) return apply_words(session.document(), session.frontend, word, arguments, whole);
    const auto fault = fault_on_selection(op, arguments);
    return fault ? usage_error(behind(word, *fault))
                 : apply_to_selection(session.document(), session.findings(), session.selecting, session.frontend, op,
                                      arguments);
  };
  const auto fault = [word, &op](Words arguments, const std::string&) -> std::optional<Text> {
    const auto wrong = is_on_selection(arguments) ? fault_on_selection(op, arguments)
                                                  : fault_of_arguments(word, op_arguments(arguments));
    return wrong ? std::optional(behind(word, *wrong)) : std::nullopt;
  };
  return {.id = op.id,
          .syntax = syntax_of(op.line),
          .help_en = op.help_en,
          .help_ja = op.help_ja,
          .effect = Effect::edits,
          .run = run,
          .aliases = op.aliases,
          .may_take_long = is_on_selection,
          .fault = fault};
}

std::optional<Text> fault_of_either(Words, const std::string& line) {
  const std::vector<std::string> lines = alternatives(behind_word(line));
  if (lines.size() < 2) return wrong_arguments("either").sentence;
  for (const std::string& each : lines)
    if (const auto fault = fault_of_command(each)) return fault;
  return std::nullopt;
}

// Of several refusals the first is told: it is what was most likely meant.
Outcome run_either(Session& session, Words arguments, std::string_view whole) {
  if (const auto fault = fault_of_either(arguments, "either " + std::string(whole))) return usage_error(*fault);
  std::optional<Outcome> told;
  for (const std::string& line : alternatives(whole)) {
    Outcome outcome = session.run(line);
    if (outcome.done() || outcome.exit_code == ExitCode::cancelled) return outcome;
    const bool is_better = !told || (told->exit_code == ExitCode::usage && outcome.exit_code == ExitCode::refused);
    if (is_better) told = std::move(outcome);
  }
  return told ? *told : wrong_arguments("either");
}

}  // namespace ryosen
