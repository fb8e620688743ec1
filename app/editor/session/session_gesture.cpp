// A gesture that moves, turns or scales the selection: what the view shows meanwhile, and how it ends.
#include <algorithm>
#include <iterator>
#include <new>

#include "app/editor/commands/commands.h"
#include "app/editor/session/session.h"
#include "app/editor/shown/gesturing.h"
#include "app/editor/shown/snapping.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/names.h"
#include "ryosen/ops/lines/arguments.h"
#include "ryosen/ops/rules/face_geometry.h"
#include "ryosen/ops/split_edge.h"

namespace ryosen {

namespace {

TouchedElements touched_by(const Mesh& mesh, const std::vector<MovedPoint>& moved) {
  TouchedElements touched;
  for (const MovedPoint& each : moved)
    for_each_copy(mesh, each.point, [&](Vertex copy) {
      touched.moved.push_back(copy);
      for (const Face f : faces_around(mesh, copy))
        if (f) touched.faces.push_back(f);
    });
  sort_unique(touched.moved);
  sort_unique(touched.faces);
  return touched;
}

PassedOver passed_over(const TouchedElements& touched) {
  PassedOver own;
  for (const Face f : touched.faces) own.faces.insert(f.index);
  for (const Vertex v : touched.moved) own.vertices.insert(v.index);
  return own;
}

// Those that would turn over or lose their area.
std::vector<Face> spoilt_faces(const Mesh& mesh, std::span<const Face> faces, std::span<const glm::dvec3> places) {
  ShapeDoubts doubts;
  for (const Face f : faces) {
    FaceGeometry before, after;
    for (const Vertex v : vertices_around(mesh, f)) {
      before.add(mesh.position(v));
      after.add(places[v.index]);
    }
    doubts.compare(before, after, f);
  }
  std::vector<Face> spoilt;
  for (const std::vector<Element>* list : {&doubts.turned, &doubts.degenerate})
    for (const Element& e : *list) spoilt.push_back(e.face());
  return spoilt;
}

// By `judged(row, face)`, of faces that are there.
template <class Judged, class Changed>
void judge_faces(HighlightSets& sets, const Mesh& mesh, std::span<const Face> faces, Judged judged, Changed changed) {
  for (const ProblemRow& row : problem_table()) {
    if (!row.face_at) continue;
    for (const Face f : faces)
      if (sets.put_member(row, f.index, mesh.exists(f) && mesh.is_alive(f) && judged(row, f)))
        changed({mark_of(row.kind), f.index});
  }
}

// The points that lie on others only because of points that are made: these themselves, and what they alone lie on.
std::vector<Vertex> coincident_by_made(const Mesh& mesh, const ProblemSets& sets, std::uint32_t first_made) {
  const bool is_known = sets.coincident().knows_places();
  const CoincidentPoints own = is_known ? CoincidentPoints() : CoincidentPoints(mesh);
  const CoincidentPoints& points = is_known ? sets.coincident() : own;
  std::vector<Vertex> found;
  IndexSet seen;
  sets.of(ProblemKind::coincident_points).for_each_from(first_made, [&](std::uint32_t i) {
    if (seen.contains(i)) return;
    std::vector<Vertex> others;
    points.for_each_at(Vertex(i), [&](Vertex v) {
      const bool is_made = v.index >= first_made;
      if (is_made) seen.insert(v.index);
      (is_made ? found : others).push_back(v);
    });
    if (others.size() == 1) found.push_back(others[0]);
  });
  return found;
}

}  // namespace

std::span<const glm::dvec3> Session::drawn_positions() const {
  return gesturing_ ? std::span<const glm::dvec3>(gesturing_->places) : mesh().positions();
}

const TransformGesture* Session::gesture() const { return gesturing_ ? &gesturing_->transform : nullptr; }

std::span<const Face> Session::spoilt_by_gesture() const {
  return gesturing_ ? std::span<const Face>(gesturing_->spoilt) : std::span<const Face>();
}

Outcome Session::begin_gesture(PointTransform::Kind kind) {
  shown.end();
  cancel_gesture();
  if (selection.empty()) return failed(ExitCode::refused, {"select something first", "先に何か選択してください"});
  begin_gesture_with(kind, selection);
  return {};
}

void Session::begin_gesture_with(PointTransform::Kind kind, Elements elements) {
  const glm::dvec3 middle = middle_of(mesh(), points_of(mesh(), elements));
  glm::dvec2 start = view.pointer - view.origin;
  if (start.x < 0 || start.y < 0 || start.x >= view.size.width || start.y >= view.size.height) {
    const auto seen = project(view.camera, view.size, middle);
    start = (seen ? seen->pixel : 0.5 * glm::dvec2(view.size.width, view.size.height)) + glm::dvec2(60, 0);
  }
  const std::span<const glm::dvec3> places = mesh().positions();
  gesturing_.reset(new Gesturing{TransformGesture(kind, mesh(), std::move(elements), start),
                                 {places.begin(), places.end()},
                                 {},
                                 {},
                                 {},
                                 {},
                                 {},
                                 start + view.origin});
  TransformGesture& transform = gesturing_->transform;
  if (const Vertex held = held_point(*this, transform.moved(), start)) transform.hold(mesh(), held);
  hover_.reset();
  pointed_handle_ = nullptr;
  pointed_axis_end_ = nullptr;
  release_verdict();
  follow_what_moves();
}

// After another set of points is moved.
void Session::follow_what_moves() {
  Gesturing& g = *gesturing_;
  note_gesture();
  judge_as_is();
  const std::span<const glm::dvec3> places = mesh().positions();
  for (const Vertex v : g.touched.moved) g.places[v.index] = places[v.index];
  g.touched = touched_by(mesh(), g.transform.moved());
  g.own.reset();
  g.triangles.clear();
  for (const Face f : g.touched.faces)
    for (const std::uint32_t slot : findings_->picker().triangles().slots_of(mesh(), f)) g.triangles.push_back(slot);
  show_gesture();
}

// The places as the gesture has them.
void Session::show_gesture() {
  Gesturing& g = *gesturing_;
  for (const MovedPoint& each : g.transform.moved()) {
    const glm::dvec3 place = g.transform.place(mesh(), each);
    for_each_copy(mesh(), each.point, [&](Vertex copy) { g.places[copy.index] = place; });
  }
  g.spoilt = spoilt_faces(mesh(), g.touched.faces, g.places);
  judge_as_drawn();
  note_gesture();
}

// Neither listed is what an operator made and nothing has moved yet, which has no extent, nor that it lies on what it was
// made of, which only the mesh on trial does.
void Session::judge_as_drawn() {
  HighlightSets* const sets = findings_->found_highlights();
  if (!gesturing_ || !sets) return;
  Gesturing& g = *gesturing_;
  if (g.pull && !g.unlisted) {
    g.unlisted = coincident_by_made(mesh(), sets->problems(), g.pull->first_made);
    list_coincident(false);
  }
  const bool is_unmoved = g.pull && g.transform.does_nothing();
  const auto judged = [&](const ProblemRow& row, Face f) {
    if (is_unmoved && std::binary_search(g.pull->made.begin(), g.pull->made.end(), f)) return false;
    return row.face_at(mesh(), f, g.places);
  };
  judge_faces(*sets, mesh(), g.touched.faces, judged, [&](ChangeFeed::Marked marked) { findings_->changes().note_mark(marked); });
}

void Session::judge_as_is() {
  HighlightSets* const sets = findings_->found_highlights();
  if (!gesturing_ || !sets) return;
  list_coincident(true);
  gesturing_->unlisted.reset();
  judge_faces(
      *sets, mesh(), gesturing_->touched.faces,
      [&](const ProblemRow& row, Face f) { return row.face_at(mesh(), f, mesh().positions()); },
      [&](ChangeFeed::Marked marked) { findings_->changes().note_mark(marked); });
}

void Session::list_coincident(bool are_listed) {
  if (!gesturing_->unlisted) return;
  const ProblemRow& row = row_of(ProblemKind::coincident_points);
  for (const Vertex v : *gesturing_->unlisted)
    if (findings_->found_highlights()->put_member(row, v.index, are_listed)) findings_->changes().note_mark({mark_of(row.kind), v.index});
}

void Session::note_gesture() {
  const Gesturing& g = *gesturing_;
  ++gesture_step_;
  for (const Vertex v : g.touched.moved) findings_->changes().note_vertex(v.index);
  findings_->picker().note_changed(g.triangles);
  if (findings_->found_highlights()) findings_->note_marks(g.touched);
}

void Session::follow_gesture(glm::dvec2 pixel, Modifiers modifiers) {
  Gesturing& g = *gesturing_;
  g.pixel = pixel;
  g.modifiers = modifiers;
  TransformGesture::Where where{.camera = view.camera,
                                .view = view.size,
                                .pixel = pixel - view.origin,
                                .snaps = modifiers.ctrl,
                                .is_fine = modifiers.shift,
                                .size_scale = preferences.size_scale()};
  if (modifiers.ctrl && g.transform.is_movement()) {
    if (!g.own) g.own = passed_over(g.touched);
    where.under = snap_target(*this, where.pixel, *g.own);
    if (!where.under && !g.step) g.step = step_of_ground(mesh());
    where.step = g.step.value_or(where.step);
  }
  g.transform.follow(mesh(), where);
  show_gesture();
}

std::optional<Outcome> Session::gesture_key(const std::string& chord) {
  if (!gesturing_) return std::nullopt;
  if (chord == "Escape") {
    return give_up_gesture();
  } else if (chord == "Enter") {
    return end_gesture();
  } else if (chord == "O" && !gesturing_->transform.takes_falloff()) {
    Outcome outcome;
    outcome.sentence = {"What is made here moves alone; a falloff is for what is there.",
                        "ここで作られる要素は単独で動きます。減衰は既存の要素の移動に使えます。"};
    return outcome;
  } else if (gesturing_->transform.key(mesh(), chord)) {
    follow_what_moves();
    follow_gesture(gesturing_->pixel, gesturing_->modifiers);
  }
  return Outcome();
}

bool Session::widen_gesture(double steps) {
  if (!gesturing_ || !gesturing_->transform.widen(mesh(), steps)) return false;
  follow_what_moves();
  return true;
}

Outcome Session::end_gesture() {
  if (!gesturing_) return {};
  const Gesturing& g = *gesturing_;
  const bool does_nothing = g.transform.does_nothing();
  if (does_nothing && !g.pull) return give_up_gesture();
  const std::optional<Gesturing::Pull> pull = g.pull;
  const std::string line =
      !pull          ? g.transform.line(mesh())
      : does_nothing ? pull->line + pull->by_nothing
                     : pull->line + format_place(pull->from.value_or(glm::dvec3(0)) + *g.transform.movement());
  cancel_gesture();
  Outcome outcome = run(line);
  if (!outcome.done() || !pull) return outcome;
  if (!pull->selected.empty()) selection = pull->selected;
  if (does_nothing && !pull->made_by_nothing.en.empty()) outcome.say(pull->made_by_nothing);
  return outcome;
}

Outcome Session::give_up_gesture() {
  Outcome outcome;
  if (gesturing_ && gesturing_->pull) outcome.sentence = gesturing_->pull->given_up;
  cancel_gesture();
  return outcome;
}

// The view is as it was. One that pulls faces out is still to be taken back by the document.
void Session::forget_gesture() {
  if (!gesturing_) return;
  judge_as_is();
  note_gesture();
  gesturing_.reset();
}

void Session::cancel_gesture() {
  if (gesturing_) shown.end();  // what it makes
  forget_gesture();
}

void Session::GesturingDeleter::operator()(Gesturing* gesturing) const { delete gesturing; }

}  // namespace ryosen
