// Gestures that move what an operator makes: extruded faces and edges, the vertex that splits an edge, a copy.
#include <algorithm>
#include <cassert>
#include <iterator>

#include "app/editor/commands/text/outcomes.h"
#include "app/editor/session/selection.h"
#include "app/editor/session/session.h"
#include "app/editor/shown/ongoing_gesture.h"
#include "ryosen/algo/algorithm_table.h"
#include "ryosen/mesh/names.h"
#include "ryosen/ops/all.h"

namespace ryosen {

namespace {

std::vector<Face> new_faces(const std::vector<Face>& touched, const ColumnLengths& before) {
  std::vector<Face> found;
  std::copy_if(touched.begin(), touched.end(), std::back_inserter(found),
               [&](Face f) { return f.index >= before.faces; });
  return found;
}

}  // namespace

// The copy lies on the original, on trial; in the end it is one duplicate that is moved already, or none.
Outcome Gesturing::begin_copy() {
  session_.shown.end();
  cancel();
  if (session_.selecting.selection.empty())
    return failed(ExitCode::refused, {"select something first", "先に何か選択してください"});
  const AlgorithmRow& row = *find_algorithm("duplicate");
  ParameterValues named(row.parameters);
  named.set_elements("elements", session_.selecting.selection, session_.selecting.selected_names());
  const ReadValues found = named.on(mesh());
  if (!found.values) return no_element(session_.document(), std::string(row.id), found.error, found.sentence);
  const FirstSlots before(mesh());
  const std::uint32_t vertices_before = mesh().vertex_slots();
  const auto tried = session_.shown.try_out(ShownBy::gesture, row, *found.values, session_.frontend.on_progress);
  if (!tried) return cancelled();
  const Elements copy = before.added_to(mesh());
  if (copy.empty()) {
    session_.shown.end();
    return failed(ExitCode::refused, tried->text);
  }
  begin_with(PointTransform::Kind::move, copy);
  ongoing_->transform.is_part_of({std::string(row.name_en), std::string(row.name_ja)});
  ongoing_->made = {.command = [call = AlgorithmCall{&row, named}](const std::optional<glm::dvec3>& way) -> Command {
                      AlgorithmCall moved = call;
                      moved.values.set_place("by", way.value_or(glm::dvec3(0)));
                      return moved;
                    },
                    .unmoved = {"The copy lies exactly on the original; undo takes it away.",
                                "複製は元とちょうど重なっています。「元に戻す」で取り消せます。"},
                    .given_up = {"No copy is left; Enter instead of Esc leaves one in its place.",
                                 "複製は残していません。その場に残すには Esc ではなく Enter を押します。"},
                    .first_made = vertices_before,
                    .selected = copy};
  session_.selecting.selection = copy;  // until the trial ends
  show();                               // the copy lies on nothing yet
  return {};
}

// The operator is on trial meanwhile; in the end it is done once with the value, or not at all.
Outcome Gesturing::begin(const AnyOp& op) {
  const OpInfo& info = info_of(op);
  const OpParameter* const place = dragged_place(info.line);
  assert(place);
  const OpDrag& drag = *place->drag;
  const void* const values = std::visit([](const auto& o) -> const void* { return &o; }, op);
  const ColumnLengths before = mesh().lengths();
  const std::optional<glm::dvec3> from = drag.from ? std::optional(drag.from(mesh(), values)) : std::nullopt;
  const Outcome outcome = session_.shown.try_out(ShownBy::gesture, op);
  if (!outcome.done()) return outcome;
  const Elements moved = drag.moved(mesh(), values, before);
  begin_with(PointTransform::Kind::move, moved);
  ongoing_->transform.is_part_of({std::string(info.name_en), std::string(info.name_ja)});
  ongoing_->made = {.command = [op, from](const std::optional<glm::dvec3>& way) -> Command {
                      return way ? dragged(op, from.value_or(glm::dvec3(0)) + *way) : op;
                    },
                    .unmoved = {std::string(drag.unmoved_en), std::string(drag.unmoved_ja)},
                    .selected = drag.selects_moved ? moved : Elements()};
  if (drag.begins_flat) {
    ongoing_->made->first_made = before.vertices;
    ongoing_->made->faces = new_faces(ongoing_->touched.faces, before);
  }
  if (drag.along_normal) key("N");
  if (drag.selects_moved) session_.selecting.selection = moved;  // until the trial ends
  if (drag.begins_flat && !drag.along_normal) show();            // without what has no extent yet
  return outcome;
}

Outcome Gesturing::begin_extrusion() {
  session_.shown.end();
  cancel();
  Extrude faces{.faces = {}, .distance = 0};
  ExtrudeEdges edges{.edges = {}, .distance = 0};
  for (const Element& e : session_.selecting.selection) {
    if (e.kind == Element::Kind::face) faces.faces.push_back(e.face());
    if (e.kind == Element::Kind::edge || e.kind == Element::Kind::halfedge)
      edges.edges.push_back(named_side(mesh(), e.kind == Element::Kind::edge ? e.edge() : edge(e.halfedge())));
  }
  if (faces.faces.empty() && edges.edges.empty())
    return failed(ExitCode::refused, {"select faces or edges first", "先に面または稜線を選択してください"});
  return faces.faces.empty() ? begin(edges) : begin(faces);
}

// Where the pointer is on the edge, else in its middle; from there the new vertex follows the pointer.
Outcome Gesturing::begin_split() {
  const std::optional<Hover> pointed = session_.selecting.hover();
  session_.shown.end();
  cancel();
  OpTarget target;
  if (pointed && pointed->op && pointed->picked.element.kind == Element::Kind::edge)
    target = session_.pointing.target_of(pointed->picked, {.shift = true});
  else if (session_.selecting.selection.size() == 1 && session_.selecting.selection[0].kind == Element::Kind::edge)
    target.halfedge = halfedge(session_.selecting.selection[0].edge());
  else if (session_.selecting.selection.size() == 1 && session_.selecting.selection[0].kind == Element::Kind::halfedge)
    target.halfedge = session_.selecting.selection[0].halfedge();
  if (!is_there(mesh(), target.halfedge))
    return failed(ExitCode::refused, {"select an edge first", "先に稜線を一つ選択してください"});
  return begin(SplitEdge::at(mesh(), target));
}

}  // namespace ryosen
