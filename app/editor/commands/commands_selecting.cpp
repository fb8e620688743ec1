// The commands `select`, `keep` and `forget`; `hide`, `isolate` and `unhide`.
#include <algorithm>

#include "app/editor/commands/command_functions.h"
#include "app/editor/commands/command_syntax.h"
#include "app/editor/commands/text/script.h"
#include "app/editor/commands/text/words.h"
#include "app/editor/document/findings.h"
#include "app/editor/input/pick_modes.h"
#include "app/editor/session/selecting.h"
#include "app/editor/session/session.h"
#include "ryosen/base/count_text.h"
#include "ryosen/base/index_set.h"
#include "ryosen/base/rows.h"
#include "ryosen/document/document.h"
#include "ryosen/mesh/find_element.h"
#include "ryosen/mesh/names.h"
#include "ryosen/scene/selection/selectors.h"

namespace ryosen {

namespace {

// What is asked for: names, behind a word that says what becomes of the selection; all that a problem is about, or all
// problems of a kind; or what a selector finds.
struct SelectRequest {
  SelectHow how = SelectHow::anew;
  const ProblemRow* problem = nullptr;
  const Selector* selector = nullptr;
  bool is_kept = false;
  bool is_wrong = false;  // it says a problem, and none that there is
  Words names;  // of elements or ranges of them; the values of a selector; the name of a selection that was kept
};

// The name that the words are: one of them, or several in quotes. None where they are neither.
std::optional<std::string> kept_name(Words words) {
  if (words.empty()) return std::nullopt;
  const char* const begin = words.front().data();  // the words are parts of one line
  const std::string_view whole(begin, static_cast<std::size_t>(words.back().data() + words.back().size() - begin));
  const bool is_quoted = whole.size() > 2 && whole.front() == '"' && whole.back() == '"';
  return words.size() == 1 || is_quoted ? std::optional(file_name(whole)) : std::nullopt;
}

Text fault_of_kept_name(std::string_view command, Words words) {
  const Text form = wrong_arguments(command).sentence;
  if (words.size() < 2) return form;
  return form + Text{"; a name of several words stands in quotes", "。空白を含む名前は引用符で囲みます"};
}

SelectRequest read_selecting(Words arguments) {
  SelectRequest asked{.names = arguments};
  const std::string_view first = arguments.empty() ? "" : arguments[0];
  if (first == of_problem) {
    asked.names = arguments.subspan(std::min<std::size_t>(arguments.size(), 2));
    if (arguments.size() == 2 || arguments.size() == 3) asked.problem = find_problem_row(arguments[1]);
    asked.is_wrong = !asked.problem;
    return asked;
  }
  if (first == "add" || first == "toggle") {
    asked.how = first == "add" ? SelectHow::add : SelectHow::toggle;
    asked.names = arguments.subspan(1);
    return asked;
  }
  asked.is_kept = first == "kept";
  asked.selector = find_selector(first);
  if (arguments.size() <= 2) asked.problem = find_problem_row(first);
  if (asked.is_kept || asked.selector || asked.problem) asked.names = arguments.subspan(1);
  return asked;
}

// The kinds of problems and the selectors that a word may stand for: those that it is a part of, else the one that it
// is a slip of.
Text meant_by(std::string_view word) {
  std::vector<std::string> known = ids_of_rows(problem_table());
  for (const Selector& row : selectors()) known.emplace_back(row.id);
  Text ids;
  for (const std::string& id : known)
    if (word.size() > 2 && id.find(word) != id.npos)
      ids += (ids.en.empty() ? Text() : Text{" or ", " か "}) + Text{id, id};
  if (ids.en.empty()) return did_you_mean(word, known);
  return Text{"; did you mean ", "。"} + ids + Text{"?", " ですか？"};
}

std::optional<Text> fault_of(const SelectRequest& asked) {
  if (asked.is_wrong) return wrong_arguments("select").sentence;
  if (asked.how != SelectHow::anew && asked.names.empty()) return wrong_arguments("select").sentence;
  if (asked.is_kept)
    return kept_name(asked.names) ? std::nullopt : std::optional(fault_of_kept_name("select", asked.names));
  if (asked.selector) {
    if (parse_values(*asked.selector, asked.names)) return std::nullopt;
    const std::string syntax = syntax_of(*asked.selector);
    if (asked.names.empty() && !asked.selector->value_en.empty())
      return Text{"select: " + std::string(asked.selector->value_en) + " is missing: " + syntax,
                  "select：" + std::string(asked.selector->value_ja) + "がありません（" + syntax + "）"};
    if (asked.selector->value == Selector::Value::map_range)
      return Text{"select: expected " + syntax + " with one of the maps " + colour_map_ids(),
                  "select：書き方は " + syntax + "（MAP は " + colour_map_ids() + "）"};
    return Text{"select: expected " + syntax, "select：書き方は " + syntax};
  }
  const bool is_kept = asked.problem && (asked.problem->is_local() || asked.problem->is_on_request());
  if (asked.problem && asked.names.empty() && !is_kept)
    return Text{"select: " + std::string(asked.problem->id) + " is not kept; name the element",
                "select：" + std::string(asked.problem->id) + " は一覧を保持していません。要素名を付けてください"};
  const auto fault = fault_of_names("select", asked.names);
  return fault && asked.names.size() == 1 ? std::optional(*fault + meant_by(asked.names[0])) : fault;
}

Elements all_of(Findings& findings, const ProblemRow& problem) {
  Elements found;
  findings.highlights().of(problem.kind).for_each([&](std::uint32_t i) { found.push_back(problem.element(i)); });
  return found;
}

Element::Kind kind_of(PickMode mode) { return pick_modes[static_cast<std::size_t>(mode)].kind; }

const PickModeRow& mode_of(Element::Kind kind) {
  return *std::find_if(std::begin(pick_modes), std::end(pick_modes),
                       [&](const PickModeRow& row) { return row.kind == kind; });
}

Outcome nothing_kept(const Selecting& selecting, std::string_view name) {
  const std::string wanted(name);
  std::vector<std::string> known;
  for (const auto& [kept, elements] : selecting.memory.kept) known.push_back(kept);
  const Text hint = did_you_mean(name, known);
  return failed(
      ExitCode::refused,
      Text{"no selection is kept as '" + wanted + "'", "「" + wanted + "」という名前の選択はありません"} + hint);
}

// What was searched for, but for what is hidden.
Outcome select(Findings& findings, Selecting& selecting, Elements found) {
  findings.drop_hidden(found);
  Outcome outcome = done_with(found.empty() ? Text{"nothing is selected", "選択はありません"}
                                            : count_text(found.size(), "one element is selected",
                                                         "# elements are selected", "# 個を選択しました"));
  selecting.selection = std::move(found);
  return outcome;
}

// All that has been found of it, and where that is nothing because nobody has searched, a word about how.
Outcome select_all_of(Findings& findings, Selecting& selecting, const ProblemRow& row) {
  Outcome outcome = select(findings, selecting, all_of(findings, row));
  if (row.is_on_request() && !findings.has_searched(row.kind)) {
    const std::string en(row.several_en), ja(row.name_ja), by(row.searched_by);
    outcome.sentence = {
        "nothing is selected: nobody has searched for " + en + " since the last edit, as " + by + " does",
        "選択はありません：「" + ja + "」は最後の編集の後、まだ探していません（" + by + " で探します）"};
  }
  return outcome;
}

// What lives of it.
Outcome select_kept(Findings& findings, Selecting& selecting, std::string_view name) {
  const auto kept = selecting.memory.kept.find(name);
  if (kept == selecting.memory.kept.end()) return nothing_kept(selecting, name);
  Elements found = kept->second;
  drop_lost(found, findings.mesh(), false);
  return select(findings, selecting, std::move(found));
}

}  // namespace

Outcome find_named(Document& document, std::string_view command, Words names, Elements& found) {
  for (const std::string_view name : names) {
    if (const auto range = parse_slot_range(name)) {
      add_living(document.mesh(), *range, found);
      continue;
    }
    const NamedElement named = find_element(document.mesh(), name);
    if (!named.element) {
      if (const auto aside = document.quarantine_text({&name, 1})) return usage_error(behind(command, *aside));
      const std::string line = std::string(command) + " " + std::string(name);
      return no_element(document, line, named.error, named.sentence);
    }
    found.push_back(*named.element);
  }
  return {};
}

std::optional<Text> fault_of_names(std::string_view command, Words names) {
  for (const std::string_view name : names)
    if (!is_element_name(name) && !parse_slot_range(name))
      return behind(command, not_understood(name, {"the name of an element", "要素の名前を"}));
  return std::nullopt;
}

std::string select_syntax() {
  std::string syntax = "[add|toggle] NAME...|A..B|[problem] PROBLEM [NAME]|kept NAME";
  for (const Selector& row : selectors()) syntax += "|" + syntax_of(row);
  return syntax;
}

void put_into_selection(Elements& selection, std::span<const Element> elements, SelectHow how) {
  if (how == SelectHow::anew) selection.clear();
  ElementSet selected(selection), taken_out;
  for (const Element& e : elements) {
    if (selected.insert(e)) {
      selection.push_back(e);
    } else if (how == SelectHow::toggle) {
      taken_out.insert(e);
    }
  }
  if (how == SelectHow::toggle) std::erase_if(selection, [&](const Element& e) { return taken_out.contains(e); });
}

std::optional<Text> fault_of_select(Words arguments, const std::string&) { return fault_of(read_selecting(arguments)); }

Outcome run_select(Session& session, Words arguments, std::string_view) {
  const SelectRequest asked = read_selecting(arguments);
  if (const auto fault = fault_of(asked)) return usage_error(*fault);
  if (asked.selector) {
    const Selector& row = *asked.selector;
    const ValueRange values = *parse_values(row, asked.names);
    if (const Text missing = missing_for(row, values, session.mesh(), session.selecting.selection); !missing.en.empty())
      return failed(ExitCode::refused, missing);
    Elements found = row.find(session.mesh(), session.selecting.selection, kind_of(session.selecting.mode), values);
    if (row.turns_into) session.run("mode " + std::string(mode_of(*row.turns_into).id));
    return select(session.findings(), session.selecting, std::move(found));
  }
  if (asked.is_kept) return select_kept(session.findings(), session.selecting, *kept_name(asked.names));
  if (asked.problem && asked.names.empty()) return select_all_of(session.findings(), session.selecting, *asked.problem);
  Elements found;
  if (Outcome outcome = find_named(session.document(), "select", asked.names, found); !outcome.done()) return outcome;
  if (asked.problem) found = session.findings().about(*asked.problem, found[0]);
  put_into_selection(session.selecting.selection.changed(), found, asked.how);
  return {};
}

std::optional<Text> fault_of_keep(Words arguments, const std::string& line) {
  if (kept_name(arguments)) return std::nullopt;
  return fault_of_kept_name(line.substr(0, line.find(' ')), arguments);
}

Outcome run_keep(Selecting& selecting, Words arguments, std::string_view) {
  const std::optional<std::string> name = kept_name(arguments);
  if (!name) return usage_error(fault_of_kept_name("keep", arguments));
  if (selecting.selection.empty())
    return failed(ExitCode::refused, {"nothing is selected that could be kept", "取っておく選択がありません"});
  selecting.memory.kept.insert_or_assign(*name, selecting.selection);
  return {};
}

Outcome run_forget(Selecting& selecting, Words arguments, std::string_view) {
  const std::optional<std::string> name = kept_name(arguments);
  if (!name) return usage_error(fault_of_kept_name("forget", arguments));
  const auto kept = selecting.memory.kept.find(*name);
  if (kept == selecting.memory.kept.end()) return nothing_kept(selecting, *name);
  selecting.memory.kept.erase(kept);
  return {};
}

namespace {

bool is_selection(Words arguments) { return arguments.size() == 1 && arguments[0] == "selected"; }

// `lacks`: what is said where nothing is selected.
Outcome hide_named(Document& document, Findings& findings, Selecting& selecting, std::string_view command,
                   Words arguments, void (Selecting::*hide)(std::span<const Element>), const Text& lacks) {
  if (arguments.empty()) return wrong_arguments(command);
  Elements elements = selecting.selection;
  if (!is_selection(arguments)) {
    elements.clear();
    if (Outcome outcome = find_named(document, command, arguments, elements); !outcome.done()) return outcome;
  } else if (elements.empty()) {
    return failed(ExitCode::refused, lacks);
  }
  (selecting.*hide)(elements);
  return done_with(hidden_text(findings.hidden()));
}

}  // namespace

std::optional<Text> fault_of_hide(Words arguments, const std::string& line) {
  const std::string command = line.substr(0, line.find(' '));
  if (arguments.empty()) return wrong_arguments(command).sentence;
  return is_selection(arguments) ? std::nullopt : fault_of_names(command, arguments);
}

Outcome run_hide(Document& document, Findings& findings, Selecting& selecting, Words arguments, std::string_view) {
  return hide_named(document, findings, selecting, "hide", arguments, &Selecting::hide,
                    {"select first what is to be hidden", "先に非表示にする要素を選択してください"});
}

Outcome run_isolate(Document& document, Findings& findings, Selecting& selecting, Words arguments, std::string_view) {
  return hide_named(document, findings, selecting, "isolate", arguments, &Selecting::isolate,
                    {"select first what alone is to be shown", "先に、それだけを表示する要素を選択してください"});
}

Outcome run_unhide(Selecting& selecting, Words arguments, std::string_view) {
  if (!arguments.empty()) return wrong_arguments("unhide");
  selecting.unhide();
  return {};
}

}  // namespace ryosen
