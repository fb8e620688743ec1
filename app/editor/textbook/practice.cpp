#include "app/editor/textbook/practice.h"

#include <algorithm>

#include "app/editor/textbook/figures.h"
#include "app/editor/textbook/practice_parts.h"
#include "ryosen/base/enum_table.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
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
    text = text + Text{", at all " + n + " copies of its point together", "（点の複製 " + n + " 個すべてで）"};
  }
  text = text + Text{"?", "。"};
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

const QuestionKindRow* find_question_kind(std::string_view id) {
  const auto found =
      std::find_if(std::begin(kind_rows), std::end(kind_rows), [&](const auto& row) { return row.id == id; });
  return found == std::end(kind_rows) ? nullptr : found;
}

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

}  // namespace ryosen
