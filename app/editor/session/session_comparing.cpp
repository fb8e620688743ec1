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
  if (!compared_) return;
  view.size.width = std::max(1, (whole.width - gap_px) / 2);
  compared_->place({std::max(1, whole.width - gap_px - view.size.width), whole.height},
                   origin + glm::dvec2(view.size.width + gap_px, 0));
}

void Session::end_comparing() {
  if (!compared_) return;
  pointing.remove(compared_->view());
  open_.findings->against = nullptr;
  compared_.reset();
}

void Session::compare_with(std::unique_ptr<Document> other) {
  Size whole = view.size;
  if (compared_) whole.width += gap_px + compared_->state().size.width;
  if (!other && view.colouring && view.colouring->map->against) view.colouring.reset();
  auto compared = other ? std::make_unique<Compared>(std::move(other), preferences) : nullptr;
  end_comparing();
  compared_ = std::move(compared);
  if (compared_) {
    pointing.add(compared_->view());
    open_.findings->against = &compared_->findings();
    compared_->findings().against = open_.findings.get();
  }
  place_view(whole, view.origin);
  framing.frame_all();
}

Compared* Session::compared() {
  if (!compared_) return nullptr;
  compared_->look_as(view);
  // Where this mesh has changed, so have the distances from it.
  if (view.colouring && view.colouring->map->against) compared_->findings().map_values(*view.colouring);
  return compared_.get();
}

SeenMesh Session::seen() { return {document(), findings(), view, preferences, gesturing.drawn_positions()}; }

}  // namespace ryosen
