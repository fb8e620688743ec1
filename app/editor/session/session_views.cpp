// The parts that the views have in the picture, and the mesh that is compared with.
#include <algorithm>

#include "app/editor/session/session.h"

namespace ryosen {

static constexpr int gap_px = 2;  // between the halves

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
  if (compared) pointing.add(compared->view());  // may find no memory
  end_comparing();
  compared_ = std::move(compared);
  // Distances are measured from another mesh.
  if (view.colouring && view.colouring->map->against) open_.findings->changes().note_everything();
  if (compared_) {
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
