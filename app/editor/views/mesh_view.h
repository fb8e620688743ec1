// The view of a mesh in space.
#pragma once

#include "app/editor/camera/view_state.h"
#include "app/editor/views/view.h"

namespace ryosen {

struct OpenDocument;

// With x-rays what the surface hides is picked, too.
inline Picker::Depth pick_depth(const ViewState& view) {
  return view.settings.xray == Xray::on ? Picker::Depth::through : Picker::Depth::seen;
}

class MeshView final : public View {
 public:
  // Both are needed as long as the view.
  MeshView(const OpenDocument& open, const ViewState& state) : open_(open), state_(state) {}

  const Document& document() const override;
  bool contains(glm::dvec2 pixel) const override;
  // None while a large mesh is prepared in the background.
  std::optional<Picked> pick(glm::dvec2 pixel, PickMode what, double radius_px) override;

 private:
  const OpenDocument& open_;
  const ViewState& state_;
};

}  // namespace ryosen
