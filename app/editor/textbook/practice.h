// Questions about the structure of a mesh, and what answers them, from the kernel.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ryosen/base/element.h"
#include "ryosen/base/message.h"
#include "ryosen/mesh/mesh.h"
#include "ryosen/textbook/forms/records.h"

namespace ryosen {

enum class QuestionKind : std::uint8_t { next, twin, record, legal, valence };
struct QuestionKindRow {
  QuestionKind kind;
  std::string_view id, en, ja;
};
// In the order of the enum.
std::span<const QuestionKindRow> question_kinds();
const QuestionKindRow* find_question_kind(std::string_view id);
// Which kind a seed asks where any will do.
QuestionKind kind_of_seed(std::uint64_t seed);

struct Question {
  QuestionKind kind = QuestionKind::next;
  Element about;
  Text asks;
  std::string form, field;  // of a question about a record
  std::string line;         // of one about an operator: what is asked for, "collapse 0-1"
};

struct Solution {
  // The words that are right, the plainest first: a slot name, a number, yes, or the id of a rule that is broken.
  std::vector<std::string> answers;
  std::optional<Element> element;  // that a click may answer with
  Text why;
  std::vector<Element> witnesses;
};

// The same seed asks the same of the same mesh. The mesh must have an edge, and for a record a face. Where the records
// of all forms of the mesh are not given, a question about one builds forms. Else the cost is that of what is at one
// element.
using AllRecords = std::span<const forms::Records>;
Question make_question(const Mesh& mesh, QuestionKind kind, std::uint64_t seed, AllRecords records = {});
Solution solve(const Mesh& mesh, const Question& question, AllRecords records = {});
// What is said of a wrong answer.
Text verdict_on_wrong(const Solution& solution);
// Answers to choose from, right and wrong ones: yes and the rules that may forbid the operator, or numbers, at most 43,
// among which the right one is. Empty where an element is asked for.
struct AnswerChoice {
  std::string word;
  Text says;
};
std::vector<AnswerChoice> answer_choices(const Question& question, const Solution& solution);
// Why a word is neither right nor wrong yet: it names several elements, and which. Else empty.
Text doubt_about(const Mesh& mesh, const Solution& solution, std::string_view word);
// Why a word cannot be an answer, right or wrong: it is none of the kind that is asked for. Else empty.
Text why_no_answer(const Mesh& mesh, const Question& question, const Solution& solution, std::string_view word);
// Whether a word is one of the answers, or names the element that is.
bool is_right(const Mesh& mesh, const Solution& solution, std::string_view word);

// The id of the figure that a seed asks about where there is no mesh: one of those that fit all kinds.
std::string_view figure_to_ask_about(std::uint64_t seed);

}  // namespace ryosen
