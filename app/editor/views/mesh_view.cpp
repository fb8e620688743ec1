#include "app/editor/views/mesh_view.h"

#include "app/editor/document/open_document.h"

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

}  // namespace ryosen
