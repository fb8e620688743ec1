#include "app/editor/textbook/practice.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>

#include "app/editor/commands/text/words.h"
#include "app/editor/textbook/figures.h"
#include "ryosen/base/enum_table.h"
#include "ryosen/base/rows.h"
#include "ryosen/document/document.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/find_element.h"
#include "ryosen/mesh/names.h"
#include "ryosen/ops/all.h"
#include "ryosen/textbook/forms/all.h"
#include "ryosen/textbook/forms/records.h"

namespace ryosen {

namespace {

constexpr QuestionKindRow kind_rows[] = {
    {QuestionKind::next, "next", "Next halfedge", "次の半稜線"},
    {QuestionKind::twin, "twin", "Twin", "対の半稜線"},
    {QuestionKind::record, "record", "What a record holds", "データの中身"},
    {QuestionKind::legal, "legal", "May it be done", "操作の可否"},
    {QuestionKind::valence, "valence", "Edges at a vertex", "頂点の稜線の本数"},
};
static_assert(rows_are_in_order(kind_rows, &QuestionKindRow::kind));

// The slot, and behind it the name where that is another one.
std::string full_name(const Mesh& mesh, Element e) {
  const std::string slot = slot_name(e), name = name_of(mesh, e);
  return name == slot ? slot : slot + " (" + name + ")";
}

// The records of a form: given, or built.
class RecordsOfForm {
 public:
  RecordsOfForm(const Mesh& mesh, const forms::FormRow& row, AllRecords given) {
    for (const forms::Records& records : given)
      if (&records.row() == &row) found_ = &records;
    if (!found_) found_ = &built_.emplace(mesh, row);
  }
  const forms::Records& operator*() const { return *found_; }
  const forms::Records* operator->() const { return found_; }

 private:
  std::optional<forms::Records> built_;
  const forms::Records* found_ = nullptr;
};

// Numbers from a seed (splitmix64), the same on every platform.
class Draws {
 public:
  explicit Draws(std::uint64_t seed) : state_(seed) {}
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(next() % n); }

 private:
  std::uint64_t next() {
    std::uint64_t z = state_ += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30u)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27u)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31u);
  }
  std::uint64_t state_;
};

template <class Handle>
Handle draw_one(const Mesh& mesh, std::uint32_t slots, Draws& draws) {
  for (;;)
    if (const Handle element(static_cast<std::uint32_t>(draws.below(slots))); mesh.is_alive(element)) return element;
}

Question ask_for_record(const Mesh& mesh, Draws& draws, AllRecords given) {
  const std::span<const forms::FormRow> rows = forms::all_forms();
  const auto has_links = [](const forms::Field& field) { return !field.is_list && field.links.size() == 1; };
  for (;;) {
    const forms::FormRow& row = rows[draws.below(rows.size())];
    const RecordsOfForm records(mesh, row, given);
    if (!records->form()) continue;
    for (int tries = 0; tries < 20; ++tries) {
      Element e;
      switch (draws.below(4)) {
        case 0:
          e = draw_one<Vertex>(mesh, mesh.vertex_slots(), draws);
          break;
        case 1:
          e = draw_one<Edge>(mesh, mesh.edge_slots(), draws);
          break;
        case 2:
          e = draw_one<Face>(mesh, mesh.face_slots(), draws);
          break;
        default:
          e = draw_one<Halfedge>(mesh, mesh.halfedge_slots(), draws);
      }
      const forms::ElementRecord record = records->of(e);
      std::vector<const forms::Field*> fields;
      for (const forms::Field& field : record.fields)
        if (has_links(field)) fields.push_back(&field);
      if (fields.empty()) continue;
      const forms::Field& field = *fields[draws.below(fields.size())];
      const std::string name = full_name(mesh, e), key(field.key), word(field.word);
      const Element link = field.links[0];
      const bool is_copy =
          link.kind == Element::Kind::vertex && link.index != no_index && has_copies(mesh, link.vertex());
      return {QuestionKind::record,
              e,
              Text{"In the form \"" + std::string(row.en) + "\": what stands in the field " + key + " (" + word +
                       ") of " + name + "?",
                   "「" + std::string(row.ja) + "」で、" + name + " の " + key + "（" + word +
                       "）には何が入っていますか。"} +
                  (is_copy ? Text{" Which of its point's copies, by its slot?",
                                  "点のどの複製かをスロット名で答えてください。"}
                           : Text()),
              std::string(row.id),
              key,
              {}};
    }
  }
}

Question ask_for_verdict(const Mesh& mesh, Draws& draws) {
  const Halfedge h = draw_one<Halfedge>(mesh, mesh.halfedge_slots(), draws);
  const bool collapses = draws.below(2) == 0;
  const AnyOp op = op_at(mesh, collapses ? CollapseEdge::info.id : SwapEdge::info.id, {h, 0.5});
  const std::string line = command_of(mesh, op), edge_name = full_name(mesh, edge(h));
  return {QuestionKind::legal,
          edge(h),
          {std::string("May the edge ") + edge_name + (collapses ? " collapse" : " be swapped") +
               "? Answer yes, or the rule that forbids it.",
           "稜線 " + edge_name + " で" + (collapses ? "稜線削除" : "稜線交換") +
               "ができますか。「はい」か、できない理由の規則で答えてください。"},
          {},
          {},
          line};
}

// What is counted where that is not plain: copies, and several edges between the same points.
Text text_of_valence(const Mesh& mesh, Vertex v) {
  const std::string name = full_name(mesh, v);
  Text text{"How many edges meet at " + name, name + " に接続する稜線は何本ですか"};
  if (has_copies(mesh, v)) {
    std::size_t copies = 0;
    for_each_copy(mesh, v, [&](Vertex) { ++copies; });
    const std::string n = std::to_string(copies);
    text += Text{", at all " + n + " copies of its point together", "（点の複製 " + n + " 個すべてで）"};
  }
  text += Text{"?", "。"};
  bool has_sheets = false;
  for_each_copy(mesh, v, [&](Vertex copy) {
    if (!mesh.is_isolated(copy))
      for (const Halfedge h : outgoing(mesh, copy)) has_sheets |= has_several_sheets(mesh, h);
  });
  return has_sheets
             ? text + Text{" Edges between the same two points count once.", "同じ二点を結ぶ稜線は一本と数えます。"}
             : text;
}

}  // namespace

std::span<const QuestionKindRow> question_kinds() { return kind_rows; }

const QuestionKindRow* find_question_kind(std::string_view id) { return find_row(kind_rows, id); }

// Drawn apart from the question itself and from the figure.
QuestionKind kind_of_seed(std::uint64_t seed) { return kind_rows[Draws(~seed).below(std::size(kind_rows))].kind; }

Question make_question(const Mesh& mesh, QuestionKind kind, std::uint64_t seed, AllRecords records) {
  Draws draws(seed);
  if (kind == QuestionKind::record) return ask_for_record(mesh, draws, records);
  if (kind == QuestionKind::legal) return ask_for_verdict(mesh, draws);
  if (kind == QuestionKind::valence) {
    const Vertex v = draw_one<Vertex>(mesh, mesh.vertex_slots(), draws);
    return {kind, v, text_of_valence(mesh, v), {}, {}, {}};
  }
  const Halfedge h = draw_one<Halfedge>(mesh, mesh.halfedge_slots(), draws);
  const std::string name = full_name(mesh, h);
  if (kind == QuestionKind::next)
    return {kind, h, {"Which halfedge is the next of " + name + "?", name + " の次の半稜線はどれですか。"}, {}, {}, {}};
  return {kind, h, {"Which halfedge is the twin of " + name + "?", name + " の対の半稜線はどれですか。"}, {}, {}, {}};
}

std::string_view figure_to_ask_about(std::uint64_t seed) {
  const std::span<const Figure> all = figures();
  return all[seed % all.size()].id;
}

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
    solution.why += Text{solution.why.en.empty() ? "" : " ", ""} + sentence;
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
