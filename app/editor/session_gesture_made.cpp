// Gestures that move what an operator makes: extruded faces, the vertex that splits an edge, a copy.
#include <algorithm>
#include <iterator>

#include "app/editor/commands.h"
#include "app/editor/gesturing.h"
#include "core/mesh/names.h"
#include "core/ops/lines/arguments.h"
#include "core/ops/split_edge.h"

namespace ryosen {

Outcome Session::begin_copy() {
  Outcome outcome = run("duplicate elements=selected");
  if (!outcome.done()) return outcome;
  begin_gesture_with(PointTransform::Kind::move, selection);
  gesturing_->is_of_copy = true;
  return outcome;
}

// Extruded by nothing, so that what is moved is there; that is on trial, and in the end it is one extrusion, or none.
Outcome Session::begin_pull() {
  end_trial();
  cancel_gesture();
  Elements faces;
  for (const Element& e : selection)
    if (e.kind == Element::Kind::face) faces.push_back(e);
  if (faces.empty()) return failed(ExitCode::refused, {"select faces first", "先に面を選択してください"});
  std::vector<std::string> names = names_of(faces);
  std::string line = "extrude ";
  for (const std::string& name : names) line += name + " ";
  names.push_back("0");
  const std::vector<std::string_view> arguments(names.begin(), names.end());
  const Parsed<AnyOp> extrusion = parse_op(mesh(), "extrude", arguments);
  if (!extrusion.op) return no_element(document(), line + "0", extrusion.error, extrusion.sentence);
  const Outcome outcome = document_->try_out(*extrusion.op);
  if (!outcome.done()) return outcome;
  std::vector<Face> pulled, made;
  for (const Element& e : faces) pulled.push_back(e.face());
  std::sort(pulled.begin(), pulled.end());
  begin_gesture_with(PointTransform::Kind::move, std::move(faces));
  const std::vector<Face>& touched = gesturing_->touched.faces;
  std::set_difference(touched.begin(), touched.end(), pulled.begin(), pulled.end(), std::back_inserter(made));
  gesturing_->pull = {std::move(line), "0", {}, std::move(made)};
  gesture_key("N");
  return outcome;
}

// Where the pointer is on the edge, else in its middle; from there the new vertex follows the pointer.
Outcome Session::begin_split() {
  const std::optional<Hover> pointed = hover_;
  end_trial();
  cancel_gesture();
  OpTarget target;
  if (pointed && pointed->op && pointed->picked.element.kind == Element::Kind::edge)
    target = target_of(pointed->picked, {.shift = true});
  else if (selection.size() == 1 && selection[0].kind == Element::Kind::edge)
    target.halfedge = halfedge(selection[0].edge());
  else if (selection.size() == 1 && selection[0].kind == Element::Kind::halfedge)
    target.halfedge = selection[0].halfedge();
  if (!is_there(mesh(), target.halfedge))
    return failed(ExitCode::refused, {"select an edge first", "先に稜線を一つ選択してください"});
  const SplitEdge split = SplitEdge::at(mesh(), target);
  const Vertex end = mesh().to(split.halfedge);
  const glm::dvec3 place = split.position(mesh());
  const std::string line = "split " + name_to_choose(mesh(), split.halfedge) + " ";
  const Outcome outcome = document_->try_out(split);
  if (!outcome.done()) return outcome;
  const Halfedge h = split.halfedge;
  const Vertex made = mesh().to(h) == end ? mesh().from(h) : mesh().to(h);
  begin_gesture_with(PointTransform::Kind::move, {made});
  gesturing_->pull = {line, format_double(split.along), place};
  return outcome;
}

}  // namespace ryosen
