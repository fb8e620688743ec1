#include "tests/support/app/random_lines.h"

#include <array>

#include "app/editor/commands/commands.h"
#include "app/editor/session/session.h"
#include "ryosen/algo/algorithm_table.h"
#include "ryosen/analysis/problem_kinds.h"
#include "ryosen/mesh/names.h"
#include "ryosen/scene/highlights/colour_maps.h"
#include "ryosen/scene/highlights/highlight_table.h"
#include "ryosen/scene/selection/selectors.h"
#include "tests/support/core/random_ops.h"
#include "tests/support/core/sound_value.h"

namespace ryosen::test {
namespace {

// The place of the bracket that closes the one at `open`.
std::size_t closing(std::string_view text, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < text.size(); ++i) {
    depth += (text[i] == '[') - (text[i] == ']');
    if (depth == 0) return i;
  }
  return text.size() - 1;
}

// The alternatives outside of brackets.
std::vector<std::string_view> alternatives(std::string_view text, std::string_view separator) {
  std::vector<std::string_view> parts;
  int depth = 0;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    depth += (text[i] == '[') - (text[i] == ']');
    if (depth > 0 || text.substr(i, separator.size()) != separator) continue;
    parts.push_back(text.substr(begin, i - begin));
    begin = i + separator.size();
  }
  parts.push_back(text.substr(begin));
  return parts;
}

bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }

constexpr std::string_view files[] = {"o.obj", "o.ply", "o.stl", "o.off", "o.png", "in.obj", "in.off", "none.obj"};
constexpr std::string_view numbers[] = {"0", "1", "2", "3", "5", "-1", "0.5", "1e-9", "30", "1%", "10%", "nan", "x"};
constexpr std::string_view garbage[] = {"",       "\"",      "{",  "v",       "f-1", "0-",
                                        "1-2@f0", "~0-1@f1", "h3", "e999999", "あ",  "="};
constexpr std::string_view chords[] = {"Ctrl+K", "Escape", "Enter", "C", "Delete", "Shift+D"};

}  // namespace

RandomLines::RandomLines(std::vector<std::string> ids, std::uint64_t seed) : ids_(std::move(ids)), dice_(seed) {
  for (const ProblemRow& row : problem_table()) words_.emplace_back(row.id);
  for (const HighlightRow& row : highlight_table()) words_.emplace_back(row.id);
  for (const AlgorithmRow& row : algorithm_table())
    if (row.is_repair()) words_.emplace_back(row.id);
}

std::string RandomLines::next(const Session& session) {
  if (dice_.one_in(2)) return operator_line(session);
  if (dice_.one_in(4)) return algorithm_line(session);
  if (dice_.one_in(4)) return dice_.one_in(2) ? "select all" : "select " + element(session) + " " + element(session);
  const std::string& id = one_of(ids_);
  const CommandRow* const row = find_command_row(id);
  std::string arguments = filled(session, row->syntax);
  if (id == "select" && dice_.one_in(2)) arguments = filled(session, one_of(selectors()).id);
  return arguments.empty() ? id : id + " " + arguments;
}

std::string RandomLines::operator_line(const Session& session) {
  const std::size_t place = static_cast<std::size_t>(dice_.below(static_cast<int>(all_ops().size())));
  const OpInfo& op = all_ops()[place];
  if (dice_.one_in(3)) return std::string(op.id) + " selected";
  if (dice_.one_in(3)) return std::string(op.id) + " " + filled(session, syntax_of(op.line));
  return command_of(session.mesh(), random_op(session.mesh(), place, dice_));
}

std::string RandomLines::algorithm_line(const Session& session) {
  const AlgorithmRow& row = one_of(algorithm_table());
  std::string line(row.id);
  for (const ParameterRow& parameter : row.parameters) {
    const bool is_needed = must_be_given(row.parameters, parameter);
    if (is_needed ? dice_.one_in(10) : !dice_.one_in(3)) continue;
    line += " " + std::string(parameter.id) + "=";
    if (dice_.one_in(2))
      line += sound_value(parameter);
    else if (parameter.kind == ParameterKind::choice)
      line += one_of(parameter.choices).id;
    else if (parameter.kind == ParameterKind::flag)
      line += dice_.one_in(2) ? "on" : "off";
    else if (parameter.kind == ParameterKind::elements)
      line += dice_.one_in(2) ? "selected" : element(session);
    else if (parameter.kind == ParameterKind::place)
      line += number() + "," + number() + "," + number();
    else
      line += number();
  }
  return line;
}

std::string RandomLines::filled(const Session& session, std::string_view syntax) {
  syntax = one_of(alternatives(syntax, " | "));
  syntax = one_of(alternatives(syntax, ", or "));
  std::string line;
  const auto add = [&](const std::string& words) { line += (line.empty() || words.empty() ? "" : " ") + words; };
  for (std::size_t i = 0; i < syntax.size();) {
    if (syntax[i] == ' ') {
      ++i;
    } else if (syntax[i] == '[') {
      const std::size_t end = closing(syntax, i);
      if (dice_.one_in(2)) add(filled(session, syntax.substr(i + 1, end - i - 1)));
      i = end + 1;
    } else {
      std::size_t end = i;
      while (end < syntax.size() && syntax[end] != ' ') end = syntax[end] == '[' ? closing(syntax, end) + 1 : end + 1;
      std::string_view word = one_of(alternatives(syntax.substr(i, end - i), "|"));
      const bool repeats = word.ends_with("...");
      if (repeats) word.remove_suffix(3);
      word = word.substr(0, word.find('['));
      for (int times = repeats ? 1 + dice_.below(3) : 1; times > 0; --times) add(word_for(session, word));
      i = end;
    }
  }
  return line;
}

std::string RandomLines::word_for(const Session& session, std::string_view placeholder) {
  if (dice_.one_in(30)) return std::string(one_of(garbage));
  if (placeholder == "FILE") return std::string(one_of(files));
  if (placeholder == "X,Y") return std::to_string(dice_.below(1300) - 10) + "," + std::to_string(dice_.below(740) - 10);
  if (placeholder == "X,Y,Z") return number() + "," + number() + "," + number();
  if (placeholder == "CHORD") return std::string(one_of(chords));
  if (placeholder == "COMMAND") return operator_line(session);
  if (placeholder == "ALGORITHM") return std::string(one_of(algorithm_table()).id);
  if (placeholder == "OPERATOR") return std::string(one_of(all_ops()).id);
  if (placeholder == "MAP") return std::string(one_of(colour_maps()).id);
  if (placeholder == "KIND" || placeholder == "PROBLEM" || placeholder == "ID") return one_of(words_);
  if (placeholder == "A..B") return "v" + std::to_string(dice_.below(9)) + "..v" + std::to_string(dice_.below(20));
  if (placeholder == "A-B" || placeholder == "NAME" || placeholder == "A" || placeholder == "B" || placeholder == "C")
    return element(session);
  if (placeholder.starts_with("f") && placeholder.size() == 2) return "f" + std::to_string(dice_.below(30));
  for (const char c : placeholder)
    if (is_capital(c)) return dice_.one_in(2) ? number() : element(session);
  return std::string(placeholder);
}

std::string RandomLines::element(const Session& session) {
  const Mesh& mesh = session.mesh();
  switch (dice_.below(8)) {
    case 0:
    case 1:
      if (const Vertex v = random_vertex(mesh, dice_)) return name_of(mesh, Element(v));
      return "v0";
    case 2:
    case 3:
      if (const Face f = random_face(mesh, dice_)) return name_of(mesh, Element(f));
      return "f0";
    case 4:
    case 5:
    case 6:
      if (const Halfedge h = random_halfedge(mesh, dice_)) return name_of(mesh, Element(edge(h)));
      return "0-1";
    default:
      return std::string(one_of(garbage));
  }
}

std::string RandomLines::number() { return std::string(one_of(numbers)); }

}  // namespace ryosen::test
