// The view of a mesh in space, the mesh as it is seen there, and one that is compared with it.
#pragma once

#include <glm/vec3.hpp>
#include <memory>
#include <span>

#include "app/editor/camera/view_state.h"
#include "app/editor/document/findings.h"
#include "app/editor/views/view.h"

namespace ryosen {

struct Preferences;

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

// A mesh as a view in space shows it: all that its picture and its labels are made from, but for what belongs to the
// mesh that is edited.
struct SeenMesh {
  const Document& document;
  Findings& findings;
  const ViewState& view;
  const Preferences& preferences;
  std::span<const glm::dvec3> places;  // where its vertices are drawn
};

// A mesh beside the open one in the picture, to be compared with: seen by the same camera in the same way, pointed at,
// never edited.
class Compared {
 public:
  Compared(std::unique_ptr<Document> document, const Preferences& preferences);
  Compared(const Compared&) = delete;
  Compared& operator=(const Compared&) = delete;

  const Document& document() const { return *open_.document; }
  const Mesh& mesh() const { return document().mesh(); }
  Findings& findings() { return *open_.findings; }
  MeshView& view() { return view_; }
  const ViewState& state() const { return state_; }
  SeenMesh seen();

  // Puts its view there in the picture.
  void place(Size size, glm::dvec2 origin);
  // Looks at it as another view looks at its own.
  void look_as(const ViewState& other);

 private:
  const Preferences& preferences_;
  ViewState state_;
  OpenDocument open_;
  MeshView view_{open_, state_};
};

}  // namespace ryosen
