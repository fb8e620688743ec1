#include "app/editor/input/view/navigation.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "app/editor/session/session.h"
#include "ryosen/geometry/box.h"

namespace ryosen {

namespace {

constexpr double double_click_s = 0.4;
constexpr double wheel_step = 1.15;      // zoom factor per wheel step
constexpr double drag_doubles_px = 120;  // length of a zoom drag that doubles the size

// The place of the mesh at a pixel, of that which is seen there: on a face, else on an edge or a vertex near by.
std::optional<glm::dvec3> place_under(Pointing& pointing, glm::dvec2 pixel) {
  for (const PickMode what : {PickMode::face, PickMode::edge, PickMode::vertex})
    if (const auto picked = pointing.pick_drawn(pixel, what)) return picked->place;
  return std::nullopt;
}

// How deep the nearest of the surface lies that a grid of rays meets, else the target.
double nearest_depth(const ViewState& view, Pointing& pointing) {
  constexpr int columns = 16, rows = 10;
  std::optional<double> nearest;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const glm::dvec2 share((column + 0.5) / columns, (row + 0.5) / rows);
      const glm::dvec2 pixel = view.origin + share * glm::dvec2(view.size.width, view.size.height);
      const auto picked = pointing.pick_drawn(pixel, PickMode::face);
      if (!picked) continue;
      const double depth = depth_of(view.camera, picked->place);
      nearest = std::min(nearest.value_or(depth), depth);
    }
  return nearest.value_or(depth_of(view.camera, view.camera.target));
}

// The point that the view moves about or towards, for a pixel.
glm::dvec3 held_at(Session& session, glm::dvec2 pixel) {
  if (const auto place = place_under(session.pointing, pixel)) return *place;
  Compared* const compared = session.compared();
  const ViewState& part = compared && compared->view().contains(pixel) ? compared->state() : session.view;
  return place_at(part.camera, part.size, pixel - part.origin, nearest_depth(part, session.pointing));
}

// What is looked at, where nothing was pressed. The wheel may have left the target before or behind all there is: then
// the middle of the mesh, or, where that is out of sight, the middle of the view as deep as its nearest surface.
glm::dvec3 middle_of_what_is_seen(const Mesh& mesh, const ViewState& view, Pointing& pointing) {
  const Camera& camera = view.camera;
  const Box box = box_of_finite(mesh.positions());
  if (box.is_empty() || box.encloses({camera.target, camera.target})) return camera.target;
  const auto at = project(camera, view.size, box.middle());
  const bool is_seen =
      at && at->pixel.x >= 0 && at->pixel.y >= 0 && at->pixel.x <= view.size.width && at->pixel.y <= view.size.height;
  if (is_seen) return box.middle();
  return place_at(camera, view.size, glm::dvec2(view.size.width, view.size.height) / 2.0,
                  nearest_depth(view, pointing));
}

glm::dvec3 centre_of_orbit(Session& session, glm::dvec2 pixel) {
  if (session.preferences.orbit_about == OrbitAbout::centre) return session.view.camera.target;
  const auto place = place_under(session.pointing, pixel);
  return place ? *place : middle_of_what_is_seen(session.mesh(), session.view, session.pointing);
}

}  // namespace

void Navigation::press(MouseButton button, glm::dvec2 pixel, Modifiers modifiers, DragAction action, double scale) {
  if (drag_ && drag_->button != button) return;
  drag_ = Drag{button, action, modifiers, pixel, pixel, click_reach_px * scale};
}

bool Navigation::move(Session& session, glm::dvec2 pixel) {
  if (!drag_) return false;
  Camera& camera = session.view.camera;
  if (!drag_->moved) {
    if (glm::length(pixel - drag_->start) <= drag_->reach_px) return false;
    drag_->moved = true;
    if (selects(drag_->action))
      session.view.band = Band{drag_->action, {drag_->start}};
    else
      drag_->held =
          drag_->action == DragAction::orbit ? centre_of_orbit(session, drag_->start) : held_at(session, drag_->start);
  }
  const glm::dvec2 moved = pixel - drag_->last;
  drag_->last = pixel;
  switch (drag_->action) {
    case DragAction::orbit:
      camera = orbited(camera, moved, session.view.size, drag_->held);
      break;
    case DragAction::pan:
      camera = panned(camera, moved, session.view.size, drag_->held);
      break;
    case DragAction::zoom:
      camera = zoomed(camera, std::exp2(-moved.y / drag_doubles_px), drag_->held);
      break;
    case DragAction::box:
    case DragAction::lasso:
      if (!session.view.band) break;  // it was given up
      if (drag_->action == DragAction::box) session.view.band->path.resize(1);
      session.view.band->path.push_back(pixel);
  }
  return true;
}

std::optional<Navigation::Click> Navigation::release(MouseButton button, glm::dvec2 pixel, double now_s) {
  if (!drag_ || drag_->button != button) return std::nullopt;
  const Drag ended = *drag_;
  drag_.reset();
  if (button == MouseButton::middle || ended.moved || glm::length(pixel - ended.start) > ended.reach_px)
    return std::nullopt;
  Click click{button, ended.start, ended.modifiers, false};
  if (button == MouseButton::right) return click;
  const auto is_bare = [](const Click& c) { return !c.modifiers.shift && !c.modifiers.ctrl && !c.modifiers.alt; };
  click.is_double = last_click_ && !last_click_->is_double && is_bare(click) && is_bare(*last_click_) &&
                    now_s - last_click_s_ < double_click_s &&
                    glm::length(last_click_->pixel - click.pixel) <= ended.reach_px;
  last_click_ = click;
  last_click_s_ = now_s;
  return click;
}

void Navigation::cancel() {
  drag_.reset();
  last_click_.reset();
}

void Navigation::wheel(Session& session, glm::dvec2 pixel, double steps) const {
  session.view.camera = zoomed(session.view.camera, std::pow(wheel_step, steps), held_at(session, pixel));
}

bool set_centre(Session& session, glm::dvec2 pixel) {
  const auto place = place_under(session.pointing, pixel);
  if (place) session.view.camera = centred(session.view.camera, *place);
  return place.has_value();
}

}  // namespace ryosen
