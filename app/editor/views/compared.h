// A mesh beside the open one in the picture, to be compared with: seen by the same camera in the same way, pointed at,
// never edited.
#pragma once

#include <memory>

#include "app/editor/camera/view_state.h"
#include "app/editor/document/open_document.h"
#include "app/editor/views/mesh_view.h"
#include "app/editor/views/seen_mesh.h"

namespace ryosen {

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
