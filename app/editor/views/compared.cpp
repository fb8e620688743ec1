#include "app/editor/views/compared.h"

#include <utility>

namespace ryosen {

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
