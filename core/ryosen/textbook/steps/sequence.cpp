#include "ryosen/textbook/steps/sequence.h"

#include <array>
#include <cassert>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ryosen/analysis/euler_poincare.h"
#include "ryosen/base/number_text.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/find_element.h"
#include "ryosen/mesh/journal.h"
#include "ryosen/mesh/rings.h"

namespace ryosen::steps {

namespace {

using Cells = std::vector<std::optional<std::string>>;

// The record that the kernel stores of an element, as cells of the tables of steps: the fields of vertices (position,
// halfedge), halfedges (from, next, prev, face) and faces (outer, inner), in that order; edges have none. A link is a
// slot name; none is no value.
struct StoredRecord {
  bool is_there = false;
  Cells values;  // empty where it is not there
};

constexpr std::array<std::string_view, 2> vertex_fields{"position", "halfedge"};
constexpr std::array<std::string_view, 4> halfedge_fields{"from", "next", "prev", "face"};
constexpr std::array<std::string_view, 2> face_fields{"outer", "inner"};

std::span<const std::string_view> fields_of(Element::Kind kind) {
  switch (kind) {
    case Element::Kind::vertex:
      return vertex_fields;
    case Element::Kind::halfedge:
      return halfedge_fields;
    case Element::Kind::face:
      return face_fields;
    case Element::Kind::edge:
      break;
  }
  return {};
}

// A slot name, or no value for none.
std::optional<std::string> link_value(Element to) {
  return to.index == no_index ? std::nullopt : std::optional(slot_name(to));
}

Cells face_cells(const Mesh& mesh, Face f) {
  std::string inner;
  for (std::uint32_t r = mesh.first_ring(f); r != no_index; r = mesh.ring(r).next)
    inner += (inner.empty() ? "" : " ") + slot_name(mesh.ring(r).halfedge);
  return {link_value(mesh.halfedge(f)), inner.empty() ? std::nullopt : std::optional(inner)};
}

StoredRecord stored_record(const Mesh& mesh, Element element) {
  if (!has_slot(mesh.lengths(), element) || !is_alive(mesh, element)) return {};
  switch (element.kind) {
    case Element::Kind::vertex:
      return {true, {format_place(mesh.position(element.vertex())), link_value(mesh.halfedge(element.vertex()))}};
    case Element::Kind::halfedge: {
      const HalfedgeLinks& links = mesh.links(element.halfedge());
      return {true, {link_value(links.from), link_value(links.next), link_value(links.prev), link_value(links.face)}};
    }
    case Element::Kind::face:
      return {true, face_cells(mesh, element.face())};
    case Element::Kind::edge:
      break;
  }
  return {true, {}};
}

// The cells in which two records of an element differ; all of one that is not there in the other.
void add_differences(Element element, const StoredRecord& was, const StoredRecord& is, std::vector<RowChange>& rows) {
  const std::span<const std::string_view> fields = fields_of(element.kind);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    RowChange row{std::string(table_of(element.kind)), slot_name(element), std::string(fields[i]), {}, {}};
    if (was.is_there) row.old_value = was.values[i];
    if (is.is_there) row.new_value = is.values[i];
    if (row.old_value != row.new_value) rows.push_back(std::move(row));
  }
}

std::vector<Element> changed_elements(const Mesh& mesh, const Journal& journal, std::size_t transaction) {
  const TouchedElements touched = touched_elements(mesh, journal, transaction);
  std::vector<Element> all;
  const auto add_slots = [&]<class Handle>(Handle, std::uint32_t slots) {
    for (std::uint32_t i = 0; i < slots; ++i) all.push_back(Handle(i));
  };
  if (touched.everything) {
    const ColumnLengths before = journal.lengths_before(transaction), after = journal.lengths_after(mesh, transaction);
    add_slots(Vertex(), std::max(before.vertices, after.vertices));
    add_slots(Halfedge(), std::max(before.halfedges, after.halfedges));
    add_slots(Face(), std::max(before.faces, after.faces));
    return all;
  }
  all.insert(all.end(), touched.vertices.begin(), touched.vertices.end());
  // That an edge is gone stands with one of its halves alone.
  for (const Halfedge h : touched.halfedges) all.insert(all.end(), {h, twin(h)});
  all.insert(all.end(), touched.faces.begin(), touched.faces.end());
  return all;
}

Delta difference(const EulerPoincare& was, const EulerPoincare& is) {
  Delta delta{.v = is.vertices - was.vertices,
              .e = is.edges - was.edges,
              .f = is.faces - was.faces,
              .b = {},
              .w = is.wire_cycles - was.wire_cycles,
              .i = is.isolated - was.isolated,
              .h = is.rings - was.rings,
              .s = is.parts - was.parts,
              .g = {}};
  if (!was.open_chain && !is.open_chain) delta.b = is.boundary_loops - was.boundary_loops;
  if (was.genus && is.genus) delta.g = *is.genus - *was.genus;
  return delta;
}

// What came, what went, and what has other values.
void add_marks(const std::vector<Element>& elements, const std::vector<StoredRecord>& was, const Mesh& mesh,
               std::vector<Mark>& marks) {
  for (std::size_t i = 0; i < elements.size() && marks.size() < RecordedSteps::most_rows; ++i) {
    const StoredRecord is = stored_record(mesh, elements[i]);
    if (!was[i].is_there && !is.is_there) continue;
    if (was[i].is_there && is.is_there && was[i].values == is.values) continue;
    const Role role = !was[i].is_there ? Role::created : !is.is_there ? Role::deleted : Role::changed;
    marks.push_back({role, elements[i]});
  }
}

}  // namespace

std::string_view table_of(Element::Kind kind) {
  constexpr std::array<std::string_view, 4> names{"vertices", "halfedges", "edges", "faces"};
  return names[static_cast<std::size_t>(kind)];
}

RecordedSteps::RecordedSteps(Mesh mesh, std::vector<Step> steps, Text remark)
    : mesh_(std::move(mesh)), steps_(std::move(steps)), positions_(steps_.size(), 0), remark_(std::move(remark)) {}

RecordedSteps::RecordedSteps(Mesh mesh, Journal journal, std::vector<Step> steps, std::vector<std::size_t> positions,
                             Text remark)
    : mesh_(std::move(mesh)),
      journal_(std::move(journal)),
      steps_(std::move(steps)),
      positions_(std::move(positions)),
      remark_(std::move(remark)) {
  assert(steps_.size() == positions_.size());
}

void RecordedSteps::go_to(std::size_t position) {
  while (journal_.position() > position) journal_.undo(mesh_);
  while (journal_.position() < position) journal_.redo(mesh_);
}

const Mesh& RecordedSteps::mesh_at(std::size_t i) {
  go_to(position_behind(i));
  return mesh_;
}

Step RecordedSteps::at(std::size_t i) {
  Step step = steps_[i - 1];
  if (position_behind(i) != position_behind(i - 1)) add_changes(step, position_behind(i - 1), position_behind(i));
  return step;
}

void RecordedSteps::add_changes(Step& step, std::size_t from, std::size_t to) {
  // Which elements the transactions touch is asked on either side of each: the links that lead to them differ.
  std::vector<Element> elements;
  for (std::size_t i = from; i < to; ++i)
    for (const std::size_t side : {i, i + 1}) {
      go_to(side);
      const std::vector<Element> more = changed_elements(mesh_, journal_, i);
      elements.insert(elements.end(), more.begin(), more.end());
    }
  sort_unique(elements);
  go_to(from);
  std::optional<EulerPoincare> terms;
  if (!step.delta) terms = euler_poincare(mesh_);
  std::vector<StoredRecord> was;
  for (const Element element : elements) was.push_back(stored_record(mesh_, element));
  go_to(to);
  std::vector<RowChange> rows;
  for (std::size_t i = 0; i < elements.size(); ++i)
    add_differences(elements[i], was[i], stored_record(mesh_, elements[i]), rows);
  const std::size_t left_out = rows.size() > most_rows ? rows.size() - most_rows : 0;
  rows.resize(rows.size() - left_out);
  step.rows.insert(step.rows.end(), rows.begin(), rows.end());
  add_marks(elements, was, mesh_, step.marks);
  if (terms) step.delta = difference(*terms, euler_poincare(mesh_));
  const Text changes = text_of(*step.delta);
  const bool is_sentence = step.caption.en.ends_with('.');
  step.caption += Text{(is_sentence ? " " : ": ") + changes.en, (is_sentence ? "" : "：") + changes.ja};
  if (left_out > 0) {
    const std::string n = std::to_string(left_out);
    step.caption += Text{" (and " + n + " more cells)", "（ほかに " + n + " 箇所）"};
  }
}

}  // namespace ryosen::steps
