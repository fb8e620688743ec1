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
#include "ryosen/mesh/circulate.h"
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
  enum class Kind { add, remove, set, get, list };
  Kind kind;
  Words words;  // behind the kind
};

std::optional<AttributeCall> read_call(Words arguments) {
  constexpr std::pair<std::string_view, AttributeCall::Kind> kinds[] = {{"add", AttributeCall::Kind::add},
                                                                        {"remove", AttributeCall::Kind::remove},
                                                                        {"set", AttributeCall::Kind::set},
                                                                        {"get", AttributeCall::Kind::get},
                                                                        {"list", AttributeCall::Kind::list}};
  for (const auto& [word, kind] : kinds) {
    if (arguments.empty() || arguments[0] != word) continue;
    const Words words = arguments.subspan(1);
    const bool has_form = kind == AttributeCall::Kind::add      ? words.size() >= 2
                          : kind == AttributeCall::Kind::remove ? words.size() == 1
                          : kind == AttributeCall::Kind::get    ? !words.empty()
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

// The corner that v3@f7, or the halfedge that 3-5@f7 names; none for other names.
std::optional<Halfedge> corner_named(const Mesh& mesh, std::string_view name) {
  const std::size_t at = name.find('@');
  if (at == std::string_view::npos) return std::nullopt;
  if (!is_vertex_name(name)) {
    const Named<Halfedge> found = find_edge(mesh, name);
    return found.ok() ? std::optional(found.element) : std::nullopt;
  }
  const Named<Vertex> v = find_vertex(mesh, name);
  const Named<Face> f = find_face(mesh, name.substr(at + 1));
  if (!v.ok() || !f.ok()) return std::nullopt;
  for (const Halfedge h : halfedges_around(mesh, f.element))
    if (mesh.from(h) == v.element) return h;
  return std::nullopt;
}

// Finds the named elements, or takes the selection where there is no name. For an attribute of corners v3@f7 is the
// corner.
Outcome find_elements(Document& document, const Selecting& selecting, const AttributeColumn* column, Words names,
                      Elements& found) {
  if (names.empty() || (names.size() == 1 && names[0] == selection_word)) {
    found = selecting.selection;
    return {};
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto corner =
        column && column->element == ElementKind::corner ? corner_named(document.mesh(), names[i]) : std::nullopt;
    if (corner)
      found.emplace_back(*corner);
    else if (Outcome outcome = find_named(document, "attribute", names.subspan(i, 1), found); !outcome.done())
      return outcome;
  }
  return {};
}

// The slot of an attribute that has the value of an element, or of a halfedge its corner; none for other kinds.
std::optional<std::uint32_t> slot_of(const Mesh& mesh, const AttributeColumn& column, const Element& e) {
  constexpr ElementKind kinds[] = {ElementKind::vertex, ElementKind::corner, ElementKind::edge, ElementKind::face};
  if (e.kind == Element::Kind::halfedge && column.element == ElementKind::edge) return edge(e.halfedge()).index;
  if (kinds[static_cast<std::size_t>(e.kind)] != column.element) return std::nullopt;
  if (e.kind == Element::Kind::halfedge && mesh.is_outside(e.halfedge())) return std::nullopt;
  return e.index;
}

Outcome get(Document& document, const Selecting& selecting, Words words) {
  const Mesh& mesh = document.mesh();
  const AttributeColumn* const column = find_column(mesh, words[0]);
  if (!column) return no_attribute(words[0]);
  Elements elements;
  if (Outcome outcome = find_elements(document, selecting, column, words.subspan(1), elements); !outcome.done())
    return outcome;
  constexpr std::size_t most_told = 100;
  std::string told;
  std::size_t count = 0;
  for (const Element& e : elements) {
    const auto slot = slot_of(mesh, *column, e);
    if (!slot || ++count > most_told) continue;
    told += (told.empty() ? "" : ", ") + name_to_select(mesh, e) + " " +
            value_text(column->type, column->data.data() + std::size_t{*slot} * column->words());
  }
  if (count == 0)
    return failed(ExitCode::refused, {"none of these elements has a value of " + column->name,
                                      column->name + " の値を持つ要素がありません"});
  if (count > most_told) told += ", ...";
  return done_with({told, told});
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
  if (Outcome outcome = find_elements(document, selecting, column, names, elements); !outcome.done()) return outcome;
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
  return "add NAME TYPE [RULE [NUMBER...]]|remove NAME|set NAME NUMBER... [selected|ELEMENT...|A..B]|"
         "get NAME [selected|ELEMENT...|A..B]|list";
}

bool attribute_only_tells(Words arguments) {
  const auto call = read_call(arguments);
  return call && (call->kind == AttributeCall::Kind::list || call->kind == AttributeCall::Kind::get);
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
  while (call->kind == AttributeCall::Kind::set && !names.empty() && is_number(names[0])) names = names.subspan(1);
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
    case AttributeCall::Kind::get:
      return get(document, selecting, call.words);
    default:
      return list(document.mesh());
  }
}

}  // namespace ryosen
