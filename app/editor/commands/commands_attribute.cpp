// The command `attribute`.
#include "app/editor/commands/command_functions.h"
#include "app/editor/commands/command_syntax.h"
#include "app/editor/commands/text/script.h"
#include "app/editor/commands/text/words.h"
#include "app/editor/session/selecting.h"
#include "ryosen/base/number_text.h"
#include "ryosen/document/document.h"
#include "ryosen/io/reporter.h"
#include "ryosen/mesh/attribute.h"
#include "ryosen/mesh/attribute_text.h"
#include "ryosen/mesh/find_element.h"
#include "ryosen/mesh/names.h"

namespace ryosen {
namespace {

bool is_number(std::string_view word) {
  return word == "true" || word == "false" || word == "nan" || word == "inf" || word == "-inf" ||
         parse_double(word).has_value();
}

// A call without a fault has one of these forms.
struct AttributeCall {
  enum class Kind { add, remove, set, list };
  Kind kind;
  Words words;  // behind the kind
};

std::optional<AttributeCall> read_call(Words arguments) {
  constexpr std::pair<std::string_view, AttributeCall::Kind> kinds[] = {{"add", AttributeCall::Kind::add},
                                                                        {"remove", AttributeCall::Kind::remove},
                                                                        {"set", AttributeCall::Kind::set},
                                                                        {"list", AttributeCall::Kind::list}};
  for (const auto& [word, kind] : kinds) {
    if (arguments.empty() || arguments[0] != word) continue;
    const Words words = arguments.subspan(1);
    const bool has_form = kind == AttributeCall::Kind::add      ? words.size() >= 2
                          : kind == AttributeCall::Kind::remove ? words.size() == 1
                          : kind == AttributeCall::Kind::set    ? words.size() >= 2
                                                                : words.empty();
    if (has_form) return AttributeCall{kind, words};
  }
  return std::nullopt;
}

Text of_attribute(const WordFault& fault) { return Text{"attribute: ", "attribute："} + sentence_of(fault); }

std::string line_of(Words words) {
  std::string line = "attribute";
  for (const std::string_view word : words) line.append(" ").append(word);
  return line;
}

Outcome with_line(Outcome outcome, std::string line) {
  if (outcome.done()) outcome.performed = std::move(line);
  return outcome;
}

Outcome add(Document& document, Words words) {
  ReadAttribute read = read_attribute(words);
  if (read.fault) return usage_error(of_attribute(*read.fault));
  std::string line = "attribute add " + words_of(read.column);
  Outcome outcome = document.add_attribute(std::move(read.column), line);
  return with_line(std::move(outcome), std::move(line));
}

Outcome set(Document& document, const Selecting& selecting, Words words) {
  const std::string_view name = words[0];
  const AttributeColumn* const column = find_column(document.mesh(), name);
  std::vector<std::uint32_t> value(column ? column->words() : 0, 0);
  const Words rest = words.subspan(1);
  Words names;
  if (column) {
    const std::size_t count = std::min<std::size_t>(column->type.count, rest.size());
    if (const auto fault = read_value(column->type, rest.first(count), value)) return usage_error(of_attribute(*fault));
    names = rest.subspan(count);
  }
  Elements elements;
  const bool is_selection = names.empty() || (names.size() == 1 && names[0] == selection_word);
  if (is_selection)
    elements = selecting.selection;
  else if (Outcome outcome = find_named(document, "attribute", names, elements); !outcome.done())
    return outcome;
  std::string line = line_of(Words());
  line.append(" set ").append(name);
  if (column) line.append(" ").append(value_text(column->type, value.data()));
  line += slot_ranges(elements);
  const std::size_t before = document.position();
  Outcome outcome = document.set_attribute(name, elements, value, line);
  if (outcome.done() && document.position() == before)
    return with_line(done_with({"all of them have that value already", "すでにその値です"}), std::move(line));
  return with_line(std::move(outcome), std::move(line));
}

Outcome list(const Mesh& mesh) {
  Text told;
  for (const AttributeColumn* const column : free_attributes(mesh)) {
    if (!told.en.empty()) told += Text{"; ", "、"};
    const std::string words = words_of(*column);
    told += Text{words, words};
  }
  if (told.en.empty()) told = {"There are no attributes.", "属性はありません。"};
  return done_with(told);
}

}  // namespace

std::string attribute_syntax() {
  return "add NAME TYPE [RULE [NUMBER...]]|remove NAME|set NAME NUMBER... [selected|ELEMENT...|A..B]|list";
}

bool attribute_only_tells(Words arguments) {
  const auto call = read_call(arguments);
  return call && call->kind == AttributeCall::Kind::list;
}

std::optional<Text> fault_of_attribute(Words arguments, const std::string&) {
  const auto call = read_call(arguments);
  if (!call) return wrong_arguments("attribute").sentence;
  if (call->kind == AttributeCall::Kind::list) return std::nullopt;
  if (call->kind == AttributeCall::Kind::add) {
    const ReadAttribute read = read_attribute(call->words);
    return read.fault ? std::optional(of_attribute(*read.fault)) : std::nullopt;
  }
  const std::string_view known[] = {call->words[0], "bool"};
  if (const ReadAttribute read = read_attribute(known); read.fault) return of_attribute(*read.fault);
  Words names = call->words.subspan(1);
  while (!names.empty() && is_number(names[0])) names = names.subspan(1);
  return names.size() == 1 && names[0] == selection_word ? std::nullopt : fault_of_names("attribute", names);
}

Outcome run_attribute(Document& document, const Selecting& selecting, Words arguments, std::string_view) {
  if (const auto fault = fault_of_attribute(arguments, {})) return usage_error(*fault);
  const AttributeCall call = *read_call(arguments);
  switch (call.kind) {
    case AttributeCall::Kind::add:
      return add(document, call.words);
    case AttributeCall::Kind::remove:
      return with_line(document.remove_attribute(call.words[0]), line_of(arguments));
    case AttributeCall::Kind::set:
      return set(document, selecting, call.words);
    default:
      return list(document.mesh());
  }
}

}  // namespace ryosen
