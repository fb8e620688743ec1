// Gestures that move what an operator makes: extruded faces and edges, the vertex that splits an edge, a copy.
#include <algorithm>
#include <iterator>

#include "app/editor/commands/text/outcomes.h"
#include "app/editor/session/first_slots.h"
#include "app/editor/session/session.h"
#include "app/editor/shown/ongoing_gesture.h"
#include "ryosen/algo/algorithm_table.h"
#include "ryosen/base/number_text.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/names.h"
#include "ryosen/ops/split_edge.h"

namespace ryosen {

namespace {

// What an operator made at the far end of quads.
Elements new_edges_of_new_points(const Mesh& mesh, const ColumnLengths& before) {
  Elements found;
  for (std::uint32_t i = before.halfedges / 2; i < mesh.edge_slots(); ++i) {
    const Edge e(i);
    if (!mesh.is_alive(e)) continue;
    const auto [a, b] = ends(mesh, e);
    if (point(mesh, a).index >= before.vertices && point(mesh, b).index >= before.vertices) found.push_back(e);
  }
  return found;
}

std::vector<Face> new_faces(const std::vector<Face>& touched, const ColumnLengths& before) {
  std::vector<Face> found;
  std::copy_if(touched.begin(), touched.end(), std::back_inserter(found),
               [&](Face f) { return f.index >= before.faces; });
  return found;
}

Text name_of(const OpInfo& op) { return {std::string(op.name_en), std::string(op.name_ja)}; }

}  // namespace

// The copy lies on the original, on trial; in the end it is one duplicate that is moved already, or none.
Outcome Gesturing::begin_copy() {
  session_.shown.end();
  cancel();
  if (session_.selecting.selection.empty())
    return failed(ExitCode::refused, {"select something first", "先に何か選択してください"});
  const AlgorithmRow& row = *find_algorithm("duplicate");
  ParameterValues named(row.parameters);
  named.set_names("elements", session_.selecting.selected_names());
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
  ongoing_->made = {.line = "duplicate elements=selected by=",
                    .no_way = "0,0,0",
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

// Extruded by nothing, so that what is moved is there; that is on trial, and in the end it is one extrusion, or none.
Outcome Gesturing::begin_extrusion() {
  session_.shown.end();
  cancel();
  Elements faces, edges;
  for (const Element& e : session_.selecting.selection) {
    if (e.kind == Element::Kind::face) faces.push_back(e);
    if (e.kind == Element::Kind::edge) edges.push_back(e);
    if (e.kind == Element::Kind::halfedge) edges.push_back(edge(e.halfedge()));
  }
  if (faces.empty() && edges.empty())
    return failed(ExitCode::refused, {"select faces or edges first", "先に面または稜線を選択してください"});
  const std::string id(faces.empty() ? ExtrudeEdges::info.id : Extrude::info.id);
  std::vector<std::string> names = session_.selecting.names_of(faces.empty() ? edges : faces);
  std::string line = id + " ";
  for (const std::string& name : names) line += name + " ";
  names.push_back("0");
  const std::vector<std::string_view> arguments(names.begin(), names.end());
  const ParsedOp extrusion = parse_op(mesh(), id, arguments);
  if (!extrusion.op) return no_element(session_.document(), line + "0", extrusion.error, extrusion.sentence);
  const ColumnLengths before = mesh().lengths();
  const Outcome outcome = session_.shown.try_out(ShownBy::gesture, *extrusion.op);
  if (!outcome.done()) return outcome;
  const Elements made = faces.empty() ? new_edges_of_new_points(mesh(), before) : Elements();
  begin_with(PointTransform::Kind::move, faces.empty() ? made : faces);
  ongoing_->transform.is_part_of(name_of(info_of(*extrusion.op)));
  ongoing_->made = {.line = std::move(line),
                    .no_way = "0",
                    .unmoved = {"Extruded by nothing: the new faces have no extent until something is moved or "
                                "scaled; undo takes them away.",
                                "移動量ゼロで押し出しました。新しい面は、動かすか拡大縮小するまで広がりがありません。"
                                "「元に戻す」で取り消せます。"},
                    .first_made = before.vertices,
                    .faces = new_faces(ongoing_->touched.faces, before),
                    .selected = made};
  if (!faces.empty()) {
    key("N");
  } else {
    session_.selecting.selection = ongoing_->made->selected;  // until the trial ends
    show();                                                   // without what has no extent yet
  }
  return outcome;
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
  const SplitEdge split = SplitEdge::at(mesh(), target);
  const Vertex end = mesh().to(split.halfedge);
  const glm::dvec3 place = split.position(mesh());
  const std::string line = "split " + name_to_choose(mesh(), split.halfedge) + " ";
  const Outcome outcome = session_.shown.try_out(ShownBy::gesture, split);
  if (!outcome.done()) return outcome;
  const Halfedge h = split.halfedge;
  const Vertex made = mesh().to(h) == end ? mesh().from(h) : mesh().to(h);
  begin_with(PointTransform::Kind::move, {made});
  ongoing_->transform.is_part_of(name_of(SplitEdge::info));
  ongoing_->made = {.line = line, .no_way = format_double(split.along), .from = place};
  return outcome;
}

}  // namespace ryosen
