// The commands `hide`, `isolate` and `unhide`.
#include "app/editor/commands/command_functions.h"
#include "app/editor/document/findings.h"
#include "app/editor/session/selecting.h"
#include "ryosen/document/document.h"

namespace ryosen {

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
  Outcome outcome;
  outcome.sentence = hidden_text(findings.hidden());
  return outcome;
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
