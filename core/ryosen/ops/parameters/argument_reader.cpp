#include "ryosen/ops/parameters/argument_reader.h"

#include <algorithm>

#include "ryosen/mesh/copies.h"
#include "ryosen/ops/parameters/op_line.h"

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

std::string_view ArgumentReader::take() { return arguments_[next_++]; }

void ArgumentReader::fail(NameError error, Text sentence) {
  if (failed()) return;
  error_ = error;
  sentence_ = std::move(sentence);
}

void ArgumentReader::fail_at(std::string_view argument) {
  fail(NameError::malformed, not_of_syntax(argument, syntax_of(line_)));
}

void ArgumentReader::fail_missing() { fail(NameError::malformed, argument_missing(syntax_of(line_))); }

double ArgumentReader::number() {
  if (failed()) return 0;
  if (at_end()) return fail_missing(), 0;
  const std::string_view text = take();
  const auto value = parse_double(text);
  if (!value) fail_at(text);
  return value.value_or(0);
}

glm::dvec3 ArgumentReader::place() {
  if (failed()) return {};
  if (at_end()) return fail_missing(), glm::dvec3();
  const std::string_view text = take();
  const auto value = parse_place(text);
  if (!value) fail_at(text);
  return value.value_or(glm::dvec3());
}

bool ArgumentReader::word(std::string_view expected) {
  if (failed() || peek() != expected || at_end()) return false;
  ++next_;
  return true;
}

Vertex ArgumentReader::copy() {
  const std::string name(peek());
  const Vertex v = vertex();
  if (failed() || !has_copies(mesh_, v) || name.find('@') != std::string::npos) return v;
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
    const std::string_view text = peek();
    const Halfedge named = halfedge();
    if (failed()) return Halfedge();
    if (std::find(corners.begin(), corners.end(), named) != corners.end()) return named;
    const std::string n(text);
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

}  // namespace ryosen
