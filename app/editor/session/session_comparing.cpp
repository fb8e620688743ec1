// The mesh beside the open one: its part of the picture, and how it follows the view.
#include <algorithm>

#include "app/editor/session/session.h"

namespace ryosen {

namespace {

constexpr int gap_px = 2;

}  // namespace

void Session::place_view(Size whole, glm::dvec2 origin) {
  view.size = whole;
  view.origin = origin;
  if (!beside_) return;
  view.size.width = std::max(1, (whole.width - gap_px) / 2);
  beside_->view.size = {std::max(1, whole.width - gap_px - view.size.width), whole.height};
  beside_->view.origin = origin + glm::dvec2(view.size.width + gap_px, 0);
}

void Session::put_beside(std::unique_ptr<Session> other) {
  const Size whole = beside_ ? Size{view.size.width + gap_px + beside_->view.size.width, view.size.height} : view.size;
  if (!other && view.colouring && view.colouring->map->against) view.colouring.reset();
  beside_ = std::move(other);
  findings_->against = beside_ ? &beside_->findings() : nullptr;
  if (beside_) beside_->findings().against = findings_.get();
  place_view(whole, view.origin);
  framing.frame_all();
}

Session* Session::beside() {
  if (!beside_) return nullptr;
  Session& other = *beside_;
  other.view.camera = view.camera;
  other.view.settings = view.settings;
  other.preferences.language = preferences.language;
  other.view.highlights = view.highlights;
  other.view.colouring = view.colouring;
  other.preferences.crease_deg = preferences.crease_deg;
  other.preferences.ui_scale = preferences.ui_scale;
  other.preferences.display_scale = preferences.display_scale;
  other.preferences.samples = preferences.samples;
  other.view.cut = view.cut;
  other.selecting.mode = selecting.pointed_sort();
  if (view.colouring && view.colouring->map->against) other.findings().map_values();  // where this mesh has changed
  return &other;
}

Session& Session::part_at(glm::dvec2 pixel) {
  Session* const other = beside();
  if (!other) return *this;
  const glm::dvec2 inside = pixel - other->view.origin;
  const bool is_there =
      inside.x >= 0 && inside.y >= 0 && inside.x < other->view.size.width && inside.y < other->view.size.height;
  return is_there ? *other : *this;
}

}  // namespace ryosen
