#include "ryosen/ops/parameters/op_line.h"

#include <algorithm>
#include <set>

#include "ryosen/base/number_text.h"
#include "ryosen/geometry/is_finite.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/find_element.h"

namespace ryosen {

Text not_understood(std::string_view argument, const Text& expected) {
  const std::string a(argument);
  return {"'" + a + "' is not understood; expected " + expected.en,
          "「" + a + "」は解釈できません。" + expected.ja + "指定してください"};
}

Text not_of_syntax(std::string_view argument, std::string_view syntax) {
  const std::string a(argument), expected(syntax);
  if (!expected.empty()) return not_understood(argument, {expected, expected + " を"});
  return {"'" + a + "' is not understood; expected no argument", "「" + a + "」は解釈できません。引数は付けられません"};
}

Text argument_missing(std::string_view syntax) {
  const std::string expected(syntax);
  return {"an argument is missing; expected " + expected, "引数が足りません。" + expected + " を指定してください"};
}

namespace {

bool is_kind(OpValueKind kind, Element::Kind element) {
  switch (element) {
    case Element::Kind::vertex:
      return kind == OpValueKind::vertex;
    case Element::Kind::face:
      return kind == OpValueKind::face;
    default:
      return kind == OpValueKind::edge;
  }
}

// Whether an argument is a value of this kind, or written as one is. A vertex is written as whatever else is none.
bool looks_like(const OpValue& value, const OpArgument& argument) {
  if (argument.element()) return is_kind(value.kind, argument.element()->kind);
  if (argument.position()) return value.kind == OpValueKind::position && is_finite(*argument.position());
  const std::string_view word = argument.word();
  switch (value.kind) {
    case OpValueKind::vertex:
      return false;
    case OpValueKind::edge:
      return word.find('-') != std::string_view::npos || word.starts_with('h') || word.starts_with('e');
    case OpValueKind::face:
      return word.starts_with('f');
    case OpValueKind::number:
      return parse_double(word).has_value();
    case OpValueKind::position:
      return parse_place(word).has_value();
    case OpValueKind::word:
      return word == value.called;
  }
  return false;
}

}  // namespace

bool ArgumentReader::is_face_next() const { return looks_like({.kind = OpValueKind::face}, peek()); }

std::optional<Element> ArgumentReader::element_as(Element::Kind kind, const OpArgument& argument) const {
  const Element* const e = argument.element();
  if (!e || !is_alive(mesh_, *e)) return std::nullopt;
  if (e->kind == kind) return *e;
  const bool is_side_wanted = e->kind == Element::Kind::edge && kind == Element::Kind::halfedge;
  return is_side_wanted ? std::optional<Element>(named_side(mesh_, e->edge())) : std::nullopt;
}

std::string ArgumentReader::word_to_find(const OpArgument& argument) const {
  return argument.element() ? slot_name(*argument.element()) : print_argument(mesh_, argument);
}

void ArgumentReader::fail(NameError error, Text sentence) {
  if (failed()) return;
  error_ = error;
  sentence_ = std::move(sentence);
}

void ArgumentReader::fail_at(const OpArgument& argument) {
  fail(NameError::malformed, not_of_syntax(print_argument(mesh_, argument), syntax_of(line_)));
}

void ArgumentReader::fail_missing() { fail(NameError::malformed, argument_missing(syntax_of(line_))); }

double ArgumentReader::number() {
  if (failed()) return 0;
  if (at_end()) return fail_missing(), 0;
  const OpArgument& argument = take();
  const auto value = parse_double(argument.word());
  if (!value) fail_at(argument);
  return value.value_or(0);
}

glm::dvec3 ArgumentReader::place() {
  if (failed()) return {};
  if (at_end()) return fail_missing(), glm::dvec3();
  const OpArgument& argument = take();
  if (argument.position() && is_finite(*argument.position())) return *argument.position();
  const auto value = parse_place(argument.word());
  if (!value) fail_at(argument);
  return value.value_or(glm::dvec3());
}

bool ArgumentReader::word(std::string_view expected) {
  if (failed() || peek().word() != expected || at_end()) return false;
  ++next_;
  return true;
}

Vertex ArgumentReader::copy() {
  const OpArgument argument = peek();
  const Vertex v = vertex();
  const std::string name(argument.word());
  if (failed() || argument.element() || !has_copies(mesh_, v) || name.find('@') != std::string::npos) return v;
  if (name_of_copy(mesh_, v).find('@') == std::string::npos) return v;  // without a face its number is its name
  std::string list;
  for_each_copy(mesh_, v, [&](Vertex copy) { list += (list.empty() ? "" : ", ") + name_of_copy(mesh_, copy); });
  fail(NameError::ambiguous, {name + " lies on several sheets; choose one of " + list,
                              name + " は複数のシートにあります。次から選んでください：" + list});
  return Vertex();
}

Halfedge ArgumentReader::corner(Vertex v, std::span<const Halfedge> corners) {
  if (failed()) return Halfedge();
  const std::string name = name_of(mesh_, v);
  if (!at_end()) {
    const OpArgument argument = peek();
    const Halfedge named = halfedge();
    if (failed()) return Halfedge();
    if (std::find(corners.begin(), corners.end(), named) != corners.end()) return named;
    const std::string n = print_argument(mesh_, argument);
    fail(NameError::never_existed, {"'" + n + "' is not a halfedge that arrives at " + name + " in such a corner",
                                    "「" + n + "」は該当する角で " + name + " に着く半稜線ではありません"});
    return Halfedge();
  }
  if (corners.size() <= 1) return corners.empty() ? Halfedge() : corners[0];
  std::string list;
  for (Halfedge h : corners) list += (list.empty() ? "" : ", ") + name_to_choose(mesh_, h);
  fail(NameError::ambiguous, {name + " has several such corners; name the halfedge that arrives: " + list,
                              name + " には該当する角が複数あります。着く半稜線を指定してください：" + list});
  return Halfedge();
}

namespace {

std::span<const OpValue> values_of(const OpParameter& parameter) {
  return std::span(parameter.values).first(parameter.count());
}

// The value that an argument of this place is meant for; null where it is none.
const OpValue* meant(const OpParameter& parameter, const OpArgument& argument) {
  const auto values = values_of(parameter);
  if (values.size() == 1 && values[0].kind != OpValueKind::word) return &values[0];
  for (const OpValue& value : values)
    if (looks_like(value, argument)) return &value;
  for (const OpValue& value : values)
    if (value.kind == OpValueKind::vertex) return &value;
  return nullptr;
}

}  // namespace

OpParameters list_meant(const OpLine& line, const OpArgument& first) {
  const auto lists = line.all_lists();
  if (lists.empty()) return {};
  for (const OpParameters& list : lists)
    if (looks_like(list[0].values[0], first)) return list;
  return lists[0];
}

namespace {

// Whether a list goes on with this argument, rather than the parameters after it.
bool goes_on(const OpParameter& list, bool is_last, const OpArgument& argument) {
  if (is_last) return true;
  const std::string_view word = argument.word();
  return looks_like(list.values[0], argument) && !word.starts_with('-') && word.find(',') == std::string_view::npos &&
         !parse_double(word);
}

Text text_or(std::string_view en, std::string_view ja) { return {std::string(en), std::string(ja)}; }

// Reads one place; false where the operator reads the rest itself.
bool read_parameter(const OpParameters& list, std::size_t i, ArgumentReader& in, void* op) {
  const OpParameter& parameter = list[i];
  const bool is_last = i + 1 == list.size();
  if (!parameter.values[0].read) return false;
  do {
    if (in.at_end()) {
      if (!parameter.is_optional())
        parameter.missing_en.empty()
            ? in.fail_missing()
            : in.fail(NameError::malformed, text_or(parameter.missing_en, parameter.missing_ja));
      return true;
    }
    const OpValue* value = meant(parameter, in.peek());
    if (value) {
      value->read(in, op);
    } else {
      parameter.expected_en.empty()
          ? in.fail_at(in.peek())
          : in.fail(NameError::malformed,
                    not_understood(in.peek_text(), text_or(parameter.expected_en, parameter.expected_ja)));
    }
  } while (parameter.is_list() && !in.failed() && !in.at_end() && goes_on(parameter, is_last, in.peek()));
  return true;
}

// The value that an operator keeps in a place, of several the last; the first one of a place that must have one.
const OpValue* held(const OpParameter& parameter, const void* op) {
  for (std::size_t i = parameter.count(); i-- > 0;)
    if (parameter.values[i].is_held && parameter.values[i].is_held(op)) return &parameter.values[i];
  return parameter.is_optional() ? nullptr : &parameter.values[0];
}

OpParameters list_held(const OpLine& line, const void* op) {
  const auto lists = line.all_lists();
  if (lists.empty()) return {};
  for (const OpParameters& list : lists)
    if (list[0].values[0].is_held && list[0].values[0].is_held(op)) return list;
  return lists[0];
}

using Places = std::set<std::size_t>;

// Matches arguments that need not be anything that exists, in all ways at once.
class Matcher {
 public:
  explicit Matcher(std::span<const OpArgument> arguments) : arguments_(arguments) {}

  // The positions that a list of parameters can end at.
  Places match(OpParameters list) {
    Places at{0};
    for (const OpParameter& parameter : list) at = match(parameter, at);
    return at;
  }

  // The last position at which an argument was missing or did not fit.
  std::size_t farthest() const { return farthest_; }
  // The kinds of elements that fit behind the last argument.
  const std::set<Element::Kind>& next() const { return next_; }

 private:
  Places match(const OpParameter& parameter, const Places& at) {
    Places ends = match_once(parameter, at);
    if (parameter.is_optional()) ends.insert(at.begin(), at.end());
    if (parameter.is_list())
      for (Places more = match_once(parameter, ends); !more.empty(); more = match_once(parameter, more))
        ends.insert(more.begin(), more.end());
    return ends;
  }

  Places match_once(const OpParameter& parameter, const Places& at) {
    Places ends;
    const auto values = values_of(parameter);
    for (const std::size_t i : at) {
      if (i == arguments_.size()) note_next(values);
      if (i < arguments_.size() &&
          std::any_of(values.begin(), values.end(), [&](const OpValue& value) { return fits(value, arguments_[i]); }))
        ends.insert(i + 1);
      else
        farthest_ = std::max(farthest_, i);
    }
    return ends;
  }

  void note_next(std::span<const OpValue> values) {
    for (const OpValue& value : values) {
      if (value.kind == OpValueKind::vertex) next_.insert(Element::Kind::vertex);
      if (value.kind == OpValueKind::edge) next_.insert(Element::Kind::edge);
      if (value.kind == OpValueKind::face) next_.insert(Element::Kind::face);
    }
  }

  static bool fits(const OpValue& value, const OpArgument& argument) {
    if (!argument.is_word()) return looks_like(value, argument);
    switch (value.kind) {
      case OpValueKind::vertex:
        return is_vertex_name(argument.word());
      case OpValueKind::edge:
        return is_edge_name(argument.word());
      case OpValueKind::face:
        return is_face_name(argument.word());
      default:
        return looks_like(value, argument);
    }
  }

  std::span<const OpArgument> arguments_;
  std::size_t farthest_ = 0;
  std::set<Element::Kind> next_;
};

}  // namespace

std::string syntax_of(const OpParameter& parameter) {
  std::string values;
  for (const OpValue& value : values_of(parameter)) values.append(values.empty() ? "" : "|").append(value.called);
  return values;
}

std::string syntax_of(const OpLine& line) {
  std::string text;
  for (const OpParameters& list : line.all_lists()) {
    if (!text.empty()) text += " | ";
    for (const OpParameter& parameter : list) {
      if (&parameter != &list.front()) text += " ";
      const std::string values = syntax_of(parameter);
      text += parameter.is_optional() ? "[" + values + "]" : values;
      if (parameter.is_list()) text += parameter.more.empty() ? " ..." : " [" + std::string(parameter.more) + " ...]";
    }
  }
  return text;
}

void read_line(const OpLine& line, const Mesh& mesh, ArgumentReader& in, void* op) {
  const OpParameters list = list_meant(line, in.peek());
  bool reads_rest = false;
  for (std::size_t i = 0; i < list.size() && !in.failed() && !reads_rest; ++i)
    reads_rest = !read_parameter(list, i, in, op);
  if (!in.failed() && line.read_rest) line.read_rest(mesh, in, op);
  if (!in.failed() && !in.at_end()) in.fail_at(in.peek());
  if (!in.failed() && line.normalise) line.normalise(mesh, op);
  if (in.failed() || !line.fault) return;
  if (const auto expected = line.fault(mesh, op))
    in.fail(NameError::malformed, not_understood(in.last_text(), *expected));
}

std::string print_line(const OpLine& line, const Mesh& mesh, const void* op) {
  std::string text;
  bool has_rest = false;
  for (const OpParameter& parameter : list_held(line, op)) {
    const bool is_rest = !parameter.values[0].read;
    if (is_rest && !has_rest && line.print_rest) line.print_rest(mesh, op, text);
    has_rest = has_rest || is_rest;
    const OpValue* value = is_rest ? nullptr : held(parameter, op);
    if (value && value->kind == OpValueKind::word) text.append(" ").append(value->called);
    if (value && value->print) value->print(mesh, op, text);
  }
  return text;
}

Halfedge halfedge_of(const OpLine& line, const void* op) {
  if (line.lists[0].empty()) return Halfedge();
  const OpValue& first = line.lists[0][0].values[0];
  return first.halfedge ? first.halfedge(op) : Halfedge();
}

const OpParameter* dragged_place(const OpLine& line) {
  for (const OpParameters& list : line.all_lists())
    for (const OpParameter& parameter : list)
      if (parameter.drag) return &parameter;
  return nullptr;
}

void set_dragged(const OpLine& line, void* op, const glm::dvec3& position) {
  const auto values = values_of(*dragged_place(line));
  for (const OpValue& value : values)
    if (value.clear) value.clear(op);
  for (const OpValue& value : values)
    if (value.set) value.set(op, position);
}

std::optional<std::size_t> first_misfit(const OpLine& line, std::span<const OpArgument> arguments) {
  Matcher matcher(arguments);
  Places ends;
  for (const OpParameters& list : line.all_lists()) ends.merge(matcher.match(list));
  if (line.lists[0].empty()) ends.insert(0);
  if (ends.contains(arguments.size())) return std::nullopt;
  return std::max(matcher.farthest(), ends.empty() ? 0 : *ends.rbegin());
}

std::optional<Element::Kind> next_element(const OpLine& line, std::span<const OpArgument> arguments) {
  Matcher matcher(arguments);
  for (const OpParameters& list : line.all_lists()) matcher.match(list);
  if (matcher.next().empty()) return std::nullopt;
  return *matcher.next().begin();  // in the order of the kinds
}

bool takes_any_number(const OpLine& line) {
  for (const OpParameters& list : line.all_lists())
    if (std::any_of(list.begin(), list.end(), [](const OpParameter& parameter) { return parameter.is_list(); }))
      return true;
  return false;
}

}  // namespace ryosen
