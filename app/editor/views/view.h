// A view of a document: a part of the picture that shows it, and what is under a pixel there. Elements of the document
// are hovered and selected, so that all its views mark the same; `findings().changes()` of the session tells what has
// changed. Drawing is no part of this, since scripts point and pick without a picture: app/ui draws a view, as
// viewport.h does that in space, and Session::place_view gives it its place.
#pragma once

#include <glm/vec2.hpp>
#include <optional>

#include "ryosen/scene/pick/picker.h"

namespace ryosen {

class Document;
class View;

// An element that a view has under a pixel.
struct Pointed {
  const Document* document = nullptr;  // that it is an element of
  const View* view = nullptr;          // that has it there
  glm::dvec2 pixel{0};                 // of the picture
  Picked picked;                       // the element, and the place on it
};

class View {
 public:
  virtual ~View() = default;

  virtual const Document& document() const = 0;
  // Whether a pixel of the picture lies in it.
  virtual bool contains(glm::dvec2 pixel) const = 0;
  // The nearest element of that sort that is drawn within so many pixels of a pixel of the picture; of faces the one
  // there. None where there is none, and outside the view.
  virtual std::optional<Picked> pick(glm::dvec2 pixel, PickMode what, double radius_px) = 0;
};

}  // namespace ryosen
