// What answers the questions of practice, and which words are right.
#include <algorithm>
#include <set>

#include "app/editor/textbook/practice_parts.h"
#include "ryosen/document/document.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/find_element.h"
#include "ryosen/ops/all.h"

namespace ryosen {

namespace {

Solution solve_link(const Mesh& mesh, Halfedge h, Halfedge answer, Text why) {
  return {{slot_name(answer)}, Element(answer), std::move(why), {h, answer, mesh.from(answer)}};
}

Solution solve_record(const Mesh& mesh, const Question& question, AllRecords given) {
  const forms::FormRow& row = *forms::find_form(question.form);
  const forms::ElementRecord record = RecordsOfForm(mesh, row, given)->of(question.about);
  const auto field = std::find_if(record.fields.begin(), record.fields.end(),
                                  [&](const forms::Field& f) { return f.key == question.field; });
  const Element link = field->links[0];
  Solution solution;
  solution.witnesses = {question.about};
  const std::optional<std::int64_t> stored = field->stored[0];
  const std::string number = stored ? std::to_string(*stored) : "";
  if (link.index == no_index) {
    solution.answers = {"none", "なし"};
    if (stored) solution.answers.push_back(number);
    solution.why = {"There is none." + (stored ? " It stores " + number + "." : ""),
                    "ありません。" + (stored ? "格納されているのは " + number + " です。" : "")};
    return solution;
  }
  solution.answers = {slot_name(link), number};
  solution.element = link;
  solution.witnesses.push_back(link);
  const std::string name = full_name(mesh, link);
  solution.why = {"It leads to " + name + " and stores " + number + ".",
                  name + " へのリンクで、格納されているのは " + number + " です。"};
  return solution;
}

Solution solve_verdict(const Mesh& mesh, const Question& question) {
  const Verdict verdict = check(mesh, *parse_line(mesh, question.line).op);
  if (verdict.legal())
    return {{"yes", "legal", "はい"}, {}, {"No rule is broken.", "どの規則にも反しません。"}, {question.about}};
  Solution solution;
  for (const Reason& reason : verdict.reasons) {
    solution.answers.emplace_back(text_of(reason.rule).id);
    solution.witnesses.insert(solution.witnesses.end(), reason.witnesses.begin(), reason.witnesses.end());
  }
  for (const Text& sentence : describe_first(mesh, verdict.reasons)) {
    solution.why.en += (solution.why.en.empty() ? "" : " ") + sentence.en;
    solution.why.ja += sentence.ja;
  }
  return solution;
}

// The edges of all copies of a point, as a file has them: those between the same two points are one.
Solution solve_valence(const Mesh& mesh, Vertex v) {
  constexpr std::size_t most_named = 24;
  Solution solution;
  std::set<Vertex> ends;
  for_each_copy(mesh, v, [&](Vertex copy) {
    std::string names;
    std::size_t here = 0;
    if (!mesh.is_isolated(copy))
      for (const Halfedge h : outgoing(mesh, copy)) {
        if (!ends.insert(point(mesh, mesh.to(h))).second) continue;
        solution.witnesses.push_back(edge(h));
        if (++here <= most_named) names += (names.empty() ? "" : ", ") + slot_name(edge(h));
      }
    if (here > most_named) names += ", ...";
    const std::string name = slot_name(copy);
    Text sentence{"Around " + name + ", from one halfedge to the next: " + names + ".",
                  name + " の周囲を巡ると " + names + " です。"};
    if (mesh.is_isolated(copy))
      sentence = {"No edge meets " + name + ".", name + " に接続する稜線はありません。"};
    else if (here == 0)
      sentence = {"Around " + name + " there is no further one.", name + " の周囲に新しいものはありません。"};
    solution.why = solution.why + Text{solution.why.en.empty() ? "" : " ", ""} + sentence;
  });
  solution.answers = {std::to_string(ends.size())};
  return solution;
}

}  // namespace

Solution solve(const Mesh& mesh, const Question& question, AllRecords records) {
  const Halfedge h = question.about.halfedge();
  switch (question.kind) {
    case QuestionKind::next: {
      const std::string end = slot_name(mesh.to(h)), to = full_name(mesh, mesh.next(h));
      const std::string side = mesh.face(h) ? "face " + slot_name(mesh.face(h)) : std::string("outside");
      const std::string side_ja = mesh.face(h) ? "面 " + slot_name(mesh.face(h)) : std::string("外側");
      return solve_link(
          mesh, h, mesh.next(h),
          {"It ends at " + end + "; on the same side, " + side + ", the loop goes on from there with " + to + ".",
           "終点は " + end + "。同じ側（" + side_ja + "）で、そこから先は " + to + " です。"});
    }
    case QuestionKind::twin: {
      const std::string name = slot_name(edge(h)), to = full_name(mesh, twin(h));
      return solve_link(mesh, h, twin(h),
                        {"The other halfedge of its edge " + name + " runs the other way: " + to + ".",
                         "親稜線 " + name + " のもう一方で、逆向きの " + to + " です。"});
    }
    case QuestionKind::record:
      return solve_record(mesh, question, records);
    case QuestionKind::legal:
      return solve_verdict(mesh, question);
    case QuestionKind::valence:
      return solve_valence(mesh, question.about.vertex());
  }
  return {};
}

Text verdict_on_wrong(const Solution& solution) {
  const std::vector<std::string>& answers = solution.answers;
  const auto is_japanese = [](const std::string& word) { return static_cast<unsigned char>(word.front()) >= 0x80; };
  const auto word = std::find_if(answers.begin(), answers.end(), is_japanese);
  return {"No, the right answer is " + answers.front() + ".",
          "違います。正解は" + (word == answers.end() ? " " + answers.front() + " " : "「" + *word + "」") + "です。"};
}

std::vector<AnswerChoice> answer_choices(const Question& question, const Solution& solution) {
  std::vector<AnswerChoice> choices;
  if (question.kind == QuestionKind::valence) {
    // Past the right one, so that the last is not always it; from 0 on while those are few.
    const int right = std::stoi(solution.answers.front()), first = right < 40 ? 0 : (right / 10 - 1) * 10;
    const int last = first == 0 ? std::max(12, right + 3) : first + 30;
    for (int n = first; n <= last; ++n) choices.push_back({std::to_string(n), {std::to_string(n), std::to_string(n)}});
  }
  if (question.kind != QuestionKind::legal) return choices;
  choices.push_back({"yes", {"Yes, it may.", "できます。"}});
  const std::string_view asked = split_words(question.line).front();
  for (const RuleText& rule : rule_table()) {
    if (rule.severity != RuleSeverity::refuse) continue;
    // What all operators refuse is an element that is gone, and those that are asked about are there.
    const std::vector<std::string_view> breakers = split_words(rule.operators);
    if (std::find(breakers.begin(), breakers.end(), asked) != breakers.end())
      choices.push_back({std::string(rule.id), {std::string(rule.en), std::string(rule.ja)}});
  }
  return choices;
}

namespace {

// The element that a word names as an answer; none where it is none or several.
NamedElement named_by(const Mesh& mesh, const Solution& solution, std::string_view word) {
  if (solution.element->kind != Element::Kind::halfedge) return find_element(mesh, word);
  const Named<Halfedge> named = find_edge(mesh, word);  // 1-2 means the halfedge from 1 to 2 here
  if (!named.ok()) return {{}, named.error, named.sentence};
  return word.starts_with('e') ? NamedElement() : NamedElement{named.element, {}, {}};
}

bool is_answer(const Solution& solution, std::string_view word) {
  return std::find(solution.answers.begin(), solution.answers.end(), word) != solution.answers.end();
}

bool is_number(std::string_view word) { return !word.empty() && word.find_first_not_of("0123456789") == word.npos; }

}  // namespace

Text doubt_about(const Mesh& mesh, const Solution& solution, std::string_view word) {
  if (!solution.element || is_answer(solution, word) || is_number(word)) return {};
  const NamedElement named = named_by(mesh, solution, word);
  return named.error == NameError::ambiguous ? named.sentence : Text{};
}

Text why_no_answer(const Mesh& mesh, const Question& question, const Solution& solution, std::string_view word) {
  const std::string said(word);
  const auto wanted = [&](const char* en, const char* ja) {
    return Text{"'" + said + "' is no answer: " + en, "「" + said + "」は答えになりません。" + ja};
  };
  if (is_answer(solution, word)) return {};
  switch (question.kind) {
    case QuestionKind::valence:
      return is_number(word) ? Text() : wanted("a number is asked for.", "数を答えてください。");
    case QuestionKind::legal: {
      const std::vector<AnswerChoice> choices = answer_choices(question, solution);
      const bool is_known =
          word == "no" || word == "legal" || word == "はい" || word == "いいえ" ||
          std::any_of(choices.begin(), choices.end(), [&](const AnswerChoice& choice) { return choice.word == word; });
      return is_known ? Text()
                      : wanted("yes, or the id of a rule that forbids it.", "「はい」か、禁じる規則の id です。");
    }
    case QuestionKind::record:
      if (is_number(word) || word == "none" || word == "なし") return {};
      break;
    default:
      break;
  }
  return find_element(mesh, word).error == NameError::malformed
             ? wanted("the name of an element is asked for, such as h3, 1-2, v4 or f5.",
                      "h3、1-2、v4、f5 のような要素の名前です。")
             : Text();
}

bool is_right(const Mesh& mesh, const Solution& solution, std::string_view word) {
  if (is_answer(solution, word)) return true;
  if (!solution.element || is_number(word)) return false;
  const NamedElement named = named_by(mesh, solution, word);
  return named.element && *named.element == *solution.element;
}

}  // namespace ryosen
