#include "app/editor/commands/command_syntax.h"

#include <algorithm>

#include "app/editor/commands/commands.h"
#include "app/editor/commands/text/words.h"
#include "app/editor/input/input.h"
#include "app/editor/session/session.h"
#include "ryosen/ops/all.h"

namespace ryosen {

namespace {

// The command says it itself when it is tried. A camera goes on from the one before, so only what none of two can take
// is wrong.
std::optional<Text> fault_on_nothing(const std::string& line) {
  std::optional<Text> fault;
  for (const glm::dvec3& aside : {glm::dvec3(0), glm::dvec3(-71, 0.6, 5.7)}) {
    Session session(std::make_unique<Document>());
    session.view.camera.eye += aside;
    session.view.camera.target -= aside;
    const Outcome outcome = session.run(line);
    if (outcome.exit_code != ExitCode::usage) return std::nullopt;
    fault = outcome.sentence;
  }
  return fault;
}

}  // namespace

Text behind(std::string_view id, const Text& sentence) {
  return {std::string(id) + ": " + sentence.en, std::string(id) + "：" + sentence.ja};
}

std::optional<Text> fault_of_expect(Words arguments, const std::string& line) {
  const bool is_about_command = arguments.size() > 1 && (arguments[0] == "legal" || arguments[0] == "refused");
  if (!is_about_command) return fault_on_nothing(line);
  if (!find_op(arguments[1])) return behind("expect", not_an_operator(arguments[1]));
  const auto fault = fault_of_arguments(arguments[1], op_arguments(arguments.subspan(2)));
  if (!fault) return std::nullopt;
  return behind("expect", behind(arguments[1], *fault));
}

std::optional<Text> fault_of_command(const std::string& line) {
  const std::vector<std::string_view> words = split_words(line);
  if (words.empty()) return std::nullopt;
  const auto call = call_of(line);
  if (!call) return unknown_command(words[0]).sentence;
  if (!call->row->fault) return fault_on_nothing(call->line);
  return call->row->fault(Words(split_words(call->line)).subspan(1), call->line);
}

namespace {

bool says_bind(std::string_view command) {
  const std::vector<std::string_view> words = split_words(command);
  return !words.empty() && words[0] == "bind";
}

// Whether the command binds a key, or one of those does that `either` tries.
bool binds_a_key(std::string_view command) {
  const std::vector<std::string_view> words = split_words(command);
  if (words.empty() || words[0] != "either") return says_bind(command);
  const std::vector<std::string> lines = alternatives(behind_word(command));
  return std::any_of(lines.begin(), lines.end(), says_bind);
}

}  // namespace

std::optional<Text> fault_of_binding(std::string_view chord, const std::string& command) {
  const std::string name(chord);
  const auto key = chord_from(chord);
  if (!key)
    return Text{"'" + name + "' is no key; it reads as Ctrl+Alt+Shift+K, F5, Numpad1 or Home",
                "「" + name + "」というキーはありません。Ctrl+Alt+Shift+K、F5、Numpad1、Home のように書きます"};
  if (*key == "Escape")
    return Text{"Escape always leaves what was begun; choose another key",
                "Escape は常に中止に使います。別のキーにしてください"};
  if (command.empty() || command == "none" || command == "initial") return std::nullopt;
  if (binds_a_key(command)) return Text{"a key cannot bind another key", "キーに bind を割り当てることはできません"};
  return fault_of_command(command);
}

}  // namespace ryosen
