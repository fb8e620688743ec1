// The mesh beside the open one: its part of the picture, and how it follows the view.
#include <algorithm>

#include "app/editor/session/session.h"

namespace ryosen {

namespace {

constexpr int gap_px = 2;

}  // namespace

void Session::place_view(Size whole, glm::dvec2 origin) {
  view = whole;
  view_origin = origin;
  if (!beside_) return;
  view.width = std::max(1, (whole.width - gap_px) / 2);
  beside_->view = {std::max(1, whole.width - gap_px - view.width), whole.height};
  beside_->view_origin = origin + glm::dvec2(view.width + gap_px, 0);
}

void Session::put_beside(std::unique_ptr<Session> other) {
  const Size whole = beside_ ? Size{view.width + gap_px + beside_->view.width, view.height} : view;
  if (!other && colouring && colouring->map->against) colouring.reset();
  beside_ = std::move(other);
  if (beside_) beside_->stands_beside_ = this;
  place_view(whole, view_origin);
  frame_all();
}

Session* Session::beside() {
  if (!beside_) return nullptr;
  Session& other = *beside_;
  other.camera = camera;
  other.settings = settings;
  other.language = language;
  other.shown_highlights = shown_highlights;
  other.colouring = colouring;
  other.crease_deg = crease_deg;
  other.ui_scale = ui_scale;
  other.display_scale = display_scale;
  other.samples = samples;
  other.cut = cut;
  other.mode = pointed_sort();
  if (colouring && colouring->map->against) other.map_values();  // where this mesh has changed
  return &other;
}

Session& Session::part_at(glm::dvec2 pixel) {
  Session* const other = beside();
  if (!other) return *this;
  const glm::dvec2 inside = pixel - other->view_origin;
  const bool is_there = inside.x >= 0 && inside.y >= 0 && inside.x < other->view.width && inside.y < other->view.height;
  return is_there ? *other : *this;
}

std::shared_ptr<const OtherSurface> Session::surface() {
  if (!surface_ || surface_revision_ != document_->revision()) {
    surface_ = std::make_shared<const OtherSurface>(mesh());
    surface_revision_ = document_->revision();
  }
  return surface_;
}

std::shared_ptr<const OtherSurface> Session::other_surface() {
  Session* const other = beside_ ? beside_.get() : stands_beside_;
  return other ? other->surface() : nullptr;
}

}  // namespace ryosen
