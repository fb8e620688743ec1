#include "app/editor/command_syntax.h"

#include <algorithm>

#include "app/editor/command_functions.h"
#include "app/editor/keys.h"
#include "app/editor/words.h"
#include "core/ops/lines/syntax.h"

namespace ryosen {

namespace {

Text behind(std::string_view id, const Text& sentence) {
  return {std::string(id) + ": " + sentence.en, std::string(id) + "：" + sentence.ja};
}

bool is_number(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

// What is expected of an operator's line.
std::optional<Text> fault_of_expectation(Words arguments) {
  if (!find_op(arguments[1])) return behind("expect", not_an_operator(arguments[1]));
  const auto fault = fault_of_arguments(arguments[1], arguments.subspan(2));
  if (!fault) return std::nullopt;
  return behind("expect", behind(arguments[1], *fault));
}

std::optional<Text> fault_of_selection(Words arguments) {
  if (arguments.size() == 1 && arguments[0] == "none") return std::nullopt;
  for (std::string_view name : arguments)
    if (!is_element_name(name))
      return behind("select", not_understood(name, {"the name of an element", "要素の名前を"}));
  return std::nullopt;
}

// Commands that touch files or other sessions, which must not be tried.
std::optional<Text> fault_of_files(std::string_view id, Words arguments) {
  if (id == "open" && arguments.empty()) return wrong_arguments(id).sentence;
  if (id == "recover" && !arguments.empty() && (arguments.size() != 1 || arguments[0] != "list")) {
    const Words numbers = arguments[0] == "discard" ? arguments.subspan(1) : arguments;
    if (numbers.size() > 1 || (numbers.size() == 1 && !is_number(numbers[0]))) return wrong_arguments(id).sentence;
  }
  return std::nullopt;
}

// All others say it when they are tried on nothing. A camera goes on from the one before, so only what none of two can
// take is wrong.
std::optional<Text> fault_on_nothing(const std::string& line) {
  std::optional<Text> fault;
  for (const glm::dvec3& aside : {glm::dvec3(0), glm::dvec3(-71, 0.6, 5.7)}) {
    Session session(std::make_unique<Document>());
    session.camera.eye += aside;
    session.camera.target -= aside;
    const Outcome outcome = session.run(line);
    if (outcome.exit_code != ExitCode::usage) return std::nullopt;
    fault = outcome.sentence;
  }
  return fault;
}

}  // namespace

std::optional<Text> fault_of_command(const std::string& line) {
  const std::vector<std::string_view> words = split_words(line);
  if (words.empty()) return std::nullopt;
  const std::string_view id = words[0];
  const Words arguments = std::span(words).subspan(1);
  if (find_op(id)) {
    const auto fault = fault_of_arguments(id, arguments);
    return fault ? std::optional(behind(id, *fault)) : std::nullopt;
  }
  if (!find_command_row(id)) return unknown_command(id).sentence;
  if (id == "select") return fault_of_selection(arguments);
  const bool is_about_command = id == "expect" && arguments.size() > 1;
  if (is_about_command && (arguments[0] == "legal" || arguments[0] == "refused"))
    return fault_of_expectation(arguments);
  for (std::string_view with_files : {"open", "save", "shot", "recover"})
    if (id == with_files) return fault_of_files(id, arguments);
  const KeyRow* const key = id == "key" && arguments.size() == 1 ? find_key(arguments[0]) : nullptr;
  return key ? fault_of_command(std::string(key->command)) : fault_on_nothing(line);
}

}  // namespace ryosen
