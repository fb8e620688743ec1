// A gesture that moves, turns or scales the selection: what the view shows meanwhile, and how it ends.
#include <algorithm>
#include <iterator>
#include <new>

#include "app/editor/commands/text/outcomes.h"
#include "app/editor/session/session.h"
#include "app/editor/shown/ongoing_gesture.h"
#include "app/editor/shown/snapping.h"
#include "ryosen/base/sort_unique.h"
#include "ryosen/mesh/circulate.h"
#include "ryosen/mesh/copies.h"
#include "ryosen/mesh/names.h"
#include "ryosen/ops/rules/face_geometry.h"

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

const Mesh& Gesturing::mesh() const { return session_.mesh(); }

std::span<const glm::dvec3> Gesturing::drawn_positions() const {
  return ongoing_ ? std::span<const glm::dvec3>(ongoing_->places) : mesh().positions();
}

const TransformGesture* Gesturing::transform() const { return ongoing_ ? &ongoing_->transform : nullptr; }

std::span<const Face> Gesturing::spoilt() const {
  return ongoing_ ? std::span<const Face>(ongoing_->spoilt) : std::span<const Face>();
}

Outcome Gesturing::begin(PointTransform::Kind kind) {
  session_.shown.end();
  cancel();
  if (session_.selecting.selection.empty())
    return failed(ExitCode::refused, {"select something first", "先に何か選択してください"});
  begin_with(kind, session_.selecting.selection);
  return {};
}

void Gesturing::begin_with(PointTransform::Kind kind, Elements elements) {
  const glm::dvec3 middle = middle_of(mesh(), points_of(mesh(), elements));
  glm::dvec2 start = session_.view.pointer - session_.view.origin;
  if (start.x < 0 || start.y < 0 || start.x >= session_.view.size.width || start.y >= session_.view.size.height) {
    const auto seen = project(session_.view.camera, session_.view.size, middle);
    start = (seen ? seen->pixel : 0.5 * glm::dvec2(session_.view.size.width, session_.view.size.height)) +
            glm::dvec2(60, 0);
  }
  const std::span<const glm::dvec3> places = mesh().positions();
  ongoing_.reset(new Ongoing{TransformGesture(kind, mesh(), std::move(elements), start),
                             {places.begin(), places.end()},
                             {},
                             {},
                             {},
                             {},
                             {},
                             start + session_.view.origin});
  TransformGesture& transform = ongoing_->transform;
  if (const Vertex held =
          held_point(session_.findings(), session_.view, session_.preferences, transform.moved(), start))
    transform.hold(mesh(), held);
  session_.selecting.point_to({});
  session_.selecting.release_verdict();
  session_.pointing.leave_handles();
  follow_what_moves();
}

// After another set of points is moved.
void Gesturing::follow_what_moves() {
  Ongoing& g = *ongoing_;
  note();
  judge_as_is();
  const std::span<const glm::dvec3> places = mesh().positions();
  for (const Vertex v : g.touched.moved) g.places[v.index] = places[v.index];
  g.touched = touched_by(mesh(), g.transform.moved());
  g.own.reset();
  g.triangles.clear();
  for (const Face f : g.touched.faces)
    for (const std::uint32_t slot : session_.findings().picker().triangles().slots_of(mesh(), f))
      g.triangles.push_back(slot);
  show();
}

// The places as the gesture has them.
void Gesturing::show() {
  Ongoing& g = *ongoing_;
  for (const MovedPoint& each : g.transform.moved()) {
    const glm::dvec3 place = g.transform.place(mesh(), each);
    for_each_copy(mesh(), each.point, [&](Vertex copy) { g.places[copy.index] = place; });
  }
  g.spoilt = spoilt_faces(mesh(), g.touched.faces, g.places);
  judge_as_drawn();
  note();
}

// Neither listed is what an operator made and nothing has moved yet, which has no extent, nor that it lies on what it
// was made of, which only the mesh on trial does.
void Gesturing::judge_as_drawn() {
  HighlightSets* const sets = session_.findings().found_highlights();
  if (!ongoing_ || !sets) return;
  Ongoing& g = *ongoing_;
  if (g.made && !g.unlisted) {
    g.unlisted = coincident_by_made(mesh(), sets->problems(), g.made->first_made);
    list_coincident(false);
  }
  const bool is_unmoved = g.made && g.transform.does_nothing();
  const auto judged = [&](const ProblemRow& row, Face f) {
    if (is_unmoved && std::binary_search(g.made->faces.begin(), g.made->faces.end(), f)) return false;
    return row.face_at(mesh(), f, g.places);
  };
  judge_faces(*sets, mesh(), g.touched.faces, judged,
              [&](ChangeFeed::Marked marked) { session_.findings().changes().note_mark(marked); });
}

void Gesturing::judge_as_is() {
  HighlightSets* const sets = session_.findings().found_highlights();
  if (!ongoing_ || !sets) return;
  list_coincident(true);
  ongoing_->unlisted.reset();
  judge_faces(
      *sets, mesh(), ongoing_->touched.faces,
      [&](const ProblemRow& row, Face f) { return row.face_at(mesh(), f, mesh().positions()); },
      [&](ChangeFeed::Marked marked) { session_.findings().changes().note_mark(marked); });
}

void Gesturing::list_coincident(bool are_listed) {
  if (!ongoing_->unlisted) return;
  const ProblemRow& row = row_of(ProblemKind::coincident_points);
  for (const Vertex v : *ongoing_->unlisted)
    if (session_.findings().found_highlights()->put_member(row, v.index, are_listed))
      session_.findings().changes().note_mark({mark_of(row.kind), v.index});
}

void Gesturing::note() {
  const Ongoing& g = *ongoing_;
  ++step_;
  for (const Vertex v : g.touched.moved) session_.findings().changes().note_vertex(v.index);
  session_.findings().picker().note_changed(g.triangles);
  if (session_.findings().found_highlights()) session_.findings().note_marks(g.touched);
}

void Gesturing::follow(glm::dvec2 pixel, Modifiers modifiers) {
  Ongoing& g = *ongoing_;
  g.pixel = pixel;
  g.modifiers = modifiers;
  TransformGesture::Where where{.camera = session_.view.camera,
                                .view = session_.view.size,
                                .pixel = pixel - session_.view.origin,
                                .snaps = modifiers.ctrl,
                                .is_fine = modifiers.shift,
                                .size_scale = session_.preferences.size_scale()};
  if (modifiers.ctrl && g.transform.is_movement()) {
    if (!g.own) g.own = passed_over(g.touched);
    where.under = snap_target(session_.findings(), session_.view, session_.preferences, where.pixel, *g.own);
    if (!where.under && !g.step) g.step = step_of_ground(mesh());
    where.step = g.step.value_or(where.step);
  }
  g.transform.follow(mesh(), where);
  show();
}

std::optional<Outcome> Gesturing::key(const std::string& chord) {
  if (!ongoing_) return std::nullopt;
  if (chord == "Escape") return give_up();
  if (chord == "Enter") return end();
  if (chord == "O" && !ongoing_->transform.takes_falloff())
    return done_with({"What is made here moves alone; a falloff is for what is there.",
                      "ここで作られる要素は単独で動きます。減衰は既存の要素の移動に使えます。"});
  if (ongoing_->transform.key(mesh(), chord)) {
    follow_what_moves();
    follow(ongoing_->pixel, ongoing_->modifiers);
  }
  return Outcome();
}

bool Gesturing::widen(double steps) {
  if (!ongoing_ || !ongoing_->transform.widen(mesh(), steps)) return false;
  follow_what_moves();
  return true;
}

Outcome Gesturing::end() {
  if (!ongoing_) return {};
  const Ongoing& g = *ongoing_;
  const bool does_nothing = g.transform.does_nothing();
  if (does_nothing && !g.made) return give_up();
  const std::optional<Ongoing::Made> made = g.made;
  const Command command =
      made ? made->command(does_nothing ? std::nullopt : g.transform.movement()) : Command(g.transform.call());
  cancel();
  Outcome outcome = session_.run(command);
  if (!outcome.done() || !made) return outcome;
  if (!made->selected.empty()) session_.selecting.selection = made->selected;
  if (does_nothing && !made->unmoved.en.empty()) outcome.say(made->unmoved);
  return outcome;
}

Outcome Gesturing::give_up() {
  Outcome outcome;
  if (ongoing_ && ongoing_->made) outcome.sentence = ongoing_->made->given_up;
  cancel();
  return outcome;
}

// The view is as it was. One that pulls faces out is still to be taken back by the document.
void Gesturing::forget() {
  if (!ongoing_) return;
  judge_as_is();
  note();
  ongoing_.reset();
}

void Gesturing::cancel() {
  if (ongoing_) session_.shown.end();  // what it makes
  forget();
}

void Gesturing::OngoingDeleter::operator()(Ongoing* ongoing) const { delete ongoing; }

}  // namespace ryosen
