#include "app/ui/navigation.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace ryosen {

namespace {

constexpr double double_click_s = 0.4;
constexpr double wheel_step = 1.15;      // zoom factor per wheel step
constexpr double drag_doubles_px = 120;  // length of a zoom drag that doubles the size

}  // namespace

void Navigation::press(MouseButton button, glm::dvec2 pixel, Modifiers modifiers) {
  if (drag_ && drag_->button != button) return;
  Motion motion = Motion::orbit;
  if (button == MouseButton::right || modifiers.shift)
    motion = Motion::pan;
  else if (button == MouseButton::middle && modifiers.ctrl)
    motion = Motion::zoom;
  drag_ = Drag{button, motion, pixel, pixel};
}

bool Navigation::move(Session& session, glm::dvec2 pixel) {
  if (!drag_) return false;
  drag_->moved = drag_->moved || glm::length(pixel - drag_->start) > click_reach_px;
  if (!drag_->moved) return false;
  const glm::dvec2 moved = pixel - drag_->last;
  drag_->last = pixel;
  switch (drag_->motion) {
    case Motion::orbit:
      session.camera = orbited(session.camera, moved, session.view);
      break;
    case Motion::pan:
      session.camera = panned(session.camera, moved, session.view);
      break;
    case Motion::zoom:
      session.camera = zoomed(session.camera, std::exp2(-moved.y / drag_doubles_px), drag_->start - session.view_origin,
                              session.view);
      break;
  }
  return true;
}

std::optional<Navigation::Click> Navigation::release(MouseButton button, glm::dvec2 pixel, double now_s) {
  if (!drag_ || drag_->button != button) return std::nullopt;
  const Drag ended = *drag_;
  drag_.reset();
  if (button != MouseButton::left || ended.moved || glm::length(pixel - ended.start) > click_reach_px)
    return std::nullopt;
  Click click{ended.start, false};
  click.is_double = last_click_ && !last_click_->is_double && now_s - last_click_s_ < double_click_s &&
                    glm::length(last_click_->pixel - click.pixel) <= click_reach_px;
  last_click_ = click;
  last_click_s_ = now_s;
  return click;
}

void Navigation::cancel() {
  drag_.reset();
  last_click_.reset();
}

void Navigation::wheel(Session& session, glm::dvec2 pixel, double steps) const {
  session.camera = zoomed(session.camera, std::pow(wheel_step, steps), pixel - session.view_origin, session.view);
}

bool set_centre(Session& session, glm::dvec2 pixel) {
  const auto picked = session.pick(pixel, PickMode::face);
  if (!picked) return false;
  const glm::dvec3 shift = picked->place - session.camera.target;
  session.camera.target += shift;
  session.camera.eye += shift;
  return true;
}

}  // namespace ryosen
