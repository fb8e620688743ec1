#include "app/editor/views/mesh_view.h"

#include <utility>

namespace ryosen {

const Document& MeshView::document() const { return *open_.document; }

bool MeshView::contains(glm::dvec2 pixel) const {
  const glm::dvec2 inside = pixel - state_.origin;
  return inside.x >= 0 && inside.y >= 0 && inside.x < state_.size.width && inside.y < state_.size.height;
}

std::optional<Picked> MeshView::pick(glm::dvec2 pixel, PickMode what, double radius_px) {
  Findings& findings = *open_.findings;
  if (!contains(pixel) || findings.preparing()) return std::nullopt;
  return findings.picker(state_).pick(findings.mesh(), state_.camera, state_.size, pixel - state_.origin, what,
                                      pick_depth(state_), radius_px);
}

Compared::Compared(std::unique_ptr<Document> document, const Preferences& preferences) : preferences_(preferences) {
  open_.document = std::move(document);
  open_.findings = std::make_unique<Findings>(*open_.document, state_, preferences);
}

SeenMesh Compared::seen() {
  return {*open_.document, *open_.findings, state_, preferences_, open_.document->mesh().positions()};
}

void Compared::place(Size size, glm::dvec2 origin) {
  state_.size = size;
  state_.origin = origin;
}

void Compared::look_as(const ViewState& other) {
  state_.camera = other.camera;
  state_.settings = other.settings;
  state_.highlights = other.highlights;
  state_.colouring = other.colouring;
  state_.cut = other.cut;
}

}  // namespace ryosen
