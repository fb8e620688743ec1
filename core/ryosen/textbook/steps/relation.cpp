// Each of the nine relations, and the valence, asked of every form by what its text stores: a search through all faces,
// or a walk along the links; with the number of records that this reads.
#include "ryosen/base/rows.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/textbook/forms/all.h"
#include "ryosen/textbook/forms/reading/relation_answer.h"
#include "ryosen/textbook/steps/players.h"
#include "ryosen/textbook/steps/sources.h"

namespace ryosen::steps {

namespace {

using forms::Answer;
using forms::Asked;
using forms::EdgeEnds;
using forms::ElementOf;
using forms::Relation;
using forms::RelationRow;

std::vector<Element> elements_of(const Mesh& mesh, Relation relation, const Answer& answer) {
  std::vector<Element> all;
  switch (relation) {
    case Relation::vertex_edges:
    case Relation::edge_edges:
    case Relation::face_edges:
      for (const EdgeEnds& ends : answer.edges) {
        Edge lowest;
        for (const Halfedge h : sheets_between(mesh, Vertex(ends.a), Vertex(ends.b)))
          if (edge(h).index < lowest.index) lowest = edge(h);
        all.push_back(lowest);
      }
      break;
    case Relation::vertex_faces:
    case Relation::edge_faces:
    case Relation::face_faces:
      for (const std::uint32_t f : answer.numbers) all.push_back(Face(f));
      break;
    default:
      for (const std::uint32_t v : answer.numbers) all.push_back(Vertex(v));
  }
  return all;
}

Step step_of_form(const Mesh& mesh, const forms::FormRow& form, const Asked& asked) {
  const Text place = Text{std::string(form.en) + " (" + std::string(form.source_en) + "): ",
                          std::string(form.ja) + "（" + std::string(form.source_ja) + "）："};
  Step step;
  step.source = source_of_form(form.id);
  step.marks.push_back({Role::asked, asked.element});
  forms::RecordReader reader(mesh, form);
  if (reader.unsuitable()) {
    step.caption = place + *reader.unsuitable();
    return step;
  }
  Answer answer;
  if (!answer_by_records(reader, asked, answer)) {
    step.caption = place + Text{"it stores places alone, neither vertices nor neighbours, so it cannot tell.",
                                "座標だけを持ち、頂点も隣接関係も持たないため答えられません。"};
    return step;
  }
  const bool is_number = asked.row.relation == Relation::valence;
  const std::vector<Element> found = elements_of(mesh, asked.row.relation, answer);
  mark_all(step, Role::answer, found);
  mark_all(step, Role::read, reader.read());
  const std::string records = std::to_string(reader.read().size()),
                    is = is_number ? std::to_string(found.size()) : names_text(found);
  const std::string question = std::string(asked.row.en) + " " + slot_name(asked.element),
                    question_ja = std::string(asked.row.ja) + " " + slot_name(asked.element);
  step.caption = place + Text{question + " reads " + records + " records and finds " + (is.empty() ? "nothing" : is),
                              question_ja + "：読むデータ " + records + " 個、答えは " + (is.empty() ? "なし" : is)};
  step.rows = {{"records_read", std::string(form.id), std::string(asked.row.id), {}, records},
               {"answer", std::string(form.id), std::string(asked.row.id), {}, is}};
  return step;
}

Result<Asked> asked_of(const Mesh& mesh, const RelationRow& row, const std::string& name) {
  if (row.asks == ElementOf::vertex) {
    const Result<Vertex> v = named_element(find_vertex(mesh, name));
    if (!v) return v.failure();
    return forms::asked_about(mesh, row, *v);
  }
  if (row.asks == ElementOf::face) {
    const Result<Face> f = named_element(find_face(mesh, name));
    if (!f) return f.failure();
    return forms::asked_about(mesh, row, *f);
  }
  const Result<Halfedge> h = named_element(find_edge(mesh, name));
  if (!h) return h.failure();
  return forms::asked_about(mesh, row, edge(*h));
}

}  // namespace

Made play_relation(const Mesh& mesh, Arguments arguments) {
  const std::string ids = joined_ids(forms::relations(), ", ");
  const RelationRow* const row = arguments.empty() ? nullptr : find_row(forms::relations(), arguments[0]);
  if (!row || arguments.size() != 2)
    return usage_of({"'relation R X' takes one of " + ids + " and a vertex vN, edge A-B or face fN.",
                     "relation R X の R は " + ids + "、X は頂点 vN、稜線 A-B、面 fN です。"});
  const Result<Asked> asked = asked_of(mesh, *row, arguments[1]);
  if (!asked) return asked.failure();
  std::vector<Step> steps;
  for (const forms::FormRow& form : forms::all_forms()) steps.push_back(step_of_form(mesh, form, *asked));
  return std::unique_ptr<Sequence>(std::make_unique<RecordedSteps>(mesh, std::move(steps)));
}

// All relations, of what is selected or of the first element of the kind.
Choices choices_of_relation(const Mesh& mesh, Selected selection) {
  const auto v = usual_of<Vertex>(mesh, selection);
  const auto e = usual_of<Edge>(mesh, selection);
  const auto f = usual_of<Face>(mesh, selection);
  Choices choices;
  const auto offer = [&](const RelationRow& row, const auto& element) {
    if (element) choices.push_back({std::string(row.id), slot_name(*element)});
  };
  for (const RelationRow& row : forms::relations()) {
    if (row.asks == ElementOf::vertex) offer(row, v);
    if (row.asks == ElementOf::edge) offer(row, e);
    if (row.asks == ElementOf::face) offer(row, f);
  }
  return choices;
}

}  // namespace ryosen::steps
