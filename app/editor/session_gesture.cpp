// A gesture that moves, turns or scales the selection: what the view shows meanwhile, and how it ends.
#include <algorithm>

#include "app/editor/session.h"
#include "core/base/sort_unique.h"
#include "core/mesh/circulate.h"
#include "core/mesh/copies.h"
#include "core/ops/lines/arguments.h"
#include "core/ops/rules/face_geometry.h"

namespace ryosen {

struct Session::Gesturing {
  TransformGesture transform;
  std::vector<glm::dvec3> places;  // of all vertices, as they are drawn
  TouchedElements touched;         // by what is moved
  std::vector<std::uint32_t> triangles;
  std::vector<Face> spoilt;
  glm::dvec2 pixel{0};  // of the window, where the pointer was last
  Modifiers modifiers = {};
  std::string pulls = {};  // faces that have been extruded for it, by nothing as yet
};

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

}  // namespace

std::span<const glm::dvec3> Session::drawn_positions() const {
  return gesturing_ ? std::span<const glm::dvec3>(gesturing_->places) : mesh().positions();
}

const TransformGesture* Session::gesture() const { return gesturing_ ? &gesturing_->transform : nullptr; }

std::span<const Face> Session::spoilt_by_gesture() const {
  return gesturing_ ? std::span<const Face>(gesturing_->spoilt) : std::span<const Face>();
}

Outcome Session::begin_gesture(PointTransform::Kind kind) {
  cancel_gesture();
  const Elements elements = selection;
  if (elements.empty()) return failed(ExitCode::refused, {"select something first", "先に何か選択してください"});
  const glm::dvec3 middle = middle_of(mesh(), points_of(mesh(), elements));
  glm::dvec2 start = pointer - view_origin;
  if (start.x < 0 || start.y < 0 || start.x >= view.width || start.y >= view.height) {
    const auto seen = project(camera, view, middle);
    start = (seen ? seen->pixel : 0.5 * glm::dvec2(view.width, view.height)) + glm::dvec2(60, 0);
  }
  const std::span<const glm::dvec3> places = mesh().positions();
  gesturing_.reset(new Gesturing{TransformGesture(kind, mesh(), elements, start),
                                 {places.begin(), places.end()},
                                 {},
                                 {},
                                 {},
                                 start + view_origin});
  hover_.reset();
  pointed_handle_ = nullptr;
  release_verdict();
  follow_what_moves();
  return {};
}

// After another set of points is moved.
void Session::follow_what_moves() {
  Gesturing& g = *gesturing_;
  note_gesture();
  const std::span<const glm::dvec3> places = mesh().positions();
  for (const Vertex v : g.touched.moved) g.places[v.index] = places[v.index];
  g.touched = touched_by(mesh(), g.transform.moved());
  g.triangles.clear();
  for (const Face f : g.touched.faces)
    for (const std::uint32_t slot : picker().triangles().slots_of(mesh(), f)) g.triangles.push_back(slot);
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
  note_gesture();
}

void Session::note_gesture() {
  const Gesturing& g = *gesturing_;
  ++gesture_step_;
  for (const Vertex v : g.touched.moved) drawn_changes_.vertices.push_back(v.index);
  drawn_changes_.triangles.insert(drawn_changes_.triangles.end(), g.triangles.begin(), g.triangles.end());
  if (highlights_) note_marks(g.touched);
}

void Session::follow_gesture(glm::dvec2 pixel, Modifiers modifiers) {
  Gesturing& g = *gesturing_;
  g.pixel = pixel;
  g.modifiers = modifiers;
  TransformGesture::Where where{camera, view, pixel - view_origin, modifiers.ctrl, {}};
  if (modifiers.ctrl) where.under = place_to_snap_to(pixel);
  g.transform.follow(mesh(), where);
  show_gesture();
}

// Of what is not moved itself: the nearest vertex, else edge, else face.
std::optional<glm::dvec3> Session::place_to_snap_to(glm::dvec2 pixel) {
  const std::vector<Vertex>& own = gesturing_->touched.moved;
  const auto is_own = [&](Vertex v) { return std::binary_search(own.begin(), own.end(), v); };
  for (const PickMode what : {PickMode::vertex, PickMode::edge, PickMode::face}) {
    const auto picked = pick(pixel, what);
    if (!picked) continue;
    const std::vector<Vertex> points = points_of(mesh(), std::span(&picked->element, 1));
    if (std::none_of(points.begin(), points.end(), is_own)) return picked->place;
  }
  return std::nullopt;
}

std::optional<Outcome> Session::gesture_key(const std::string& chord) {
  if (!gesturing_) return std::nullopt;
  if (chord == "Escape") {
    cancel_gesture();
    return Outcome();
  } else if (chord == "Enter") {
    return end_gesture();
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
  const std::string line = gesturing_->transform.line(mesh());
  const bool does_nothing = gesturing_->transform.does_nothing();
  const std::string pulls = gesturing_->pulls;
  const auto by = gesturing_->transform.movement();
  if (!pulls.empty() && !by && !does_nothing) gesturing_->pulls.clear();  // the extrusion stays as it is, and is moved
  cancel_gesture();
  if (does_nothing) return {};
  return !pulls.empty() && by ? run("extrude" + pulls + " " + format_place(*by)) : run(line);
}

// Extruded by nothing, so that what is moved is there; in the end it is one extrusion, or none.
Outcome Session::begin_pull() {
  cancel_gesture();
  Elements faces;
  for (const Element& e : selection)
    if (e.kind == Element::Kind::face) faces.push_back(e);
  if (faces.empty()) return failed(ExitCode::refused, {"select faces first", "先に面を選択してください"});
  std::string names;
  for (const std::string& name : names_of(faces)) names += " " + name;
  Outcome outcome = run("extrude" + names + " 0");
  if (!outcome.done()) return outcome;
  selection = faces;
  outcome = begin_gesture(PointTransform::Kind::move);
  gesturing_->pulls = names;
  gesture_key("N");
  return outcome;
}

void Session::cancel_gesture() {
  if (!gesturing_) return;
  note_gesture();
  const bool takes_back = !gesturing_->pulls.empty();
  gesturing_.reset();
  if (takes_back) run("undo");
}

void Session::GesturingDeleter::operator()(Gesturing* gesturing) const { delete gesturing; }

}  // namespace ryosen
