// What the mouse does over the view: drags move the camera, clicks are told apart from drags.
#pragma once

#include <optional>

#include "app/editor/session.h"

namespace ryosen {

enum class MouseButton { left, right, middle };  // numbered as the toolkits number them

// A click is a press and a release within this many pixels.
inline constexpr double click_reach_px = 4;

// Left drag orbits, right drag or Shift + left pans, middle drag orbits (Shift pans, Ctrl zooms), the wheel zooms to
// the pointer. Pixels are those of the window; the view may begin anywhere in it.
class Navigation {
 public:
  struct Modifiers {
    bool shift = false, ctrl = false;
  };
  struct Click {
    glm::dvec2 pixel;
    bool is_double;  // the second of two within 0.4 s at about the same place
  };

  // A drag in progress keeps going when another button is pressed; the same button begins anew.
  void press(MouseButton button, glm::dvec2 pixel, Modifiers modifiers);
  // True when the camera moved.
  bool move(Session& session, glm::dvec2 pixel);
  // A click of the left button, if that is what ended.
  std::optional<Click> release(MouseButton button, glm::dvec2 pixel, double now_s);
  void wheel(Session& session, glm::dvec2 pixel, double steps) const;
  // Forgets the drag and the last click.
  void cancel();

  bool is_dragging() const { return drag_.has_value(); }

 private:
  enum class Motion { orbit, pan, zoom };
  struct Drag {
    MouseButton button;
    Motion motion;
    glm::dvec2 start, last;
    bool moved = false;  // beyond a click's reach
  };

  std::optional<Drag> drag_;
  std::optional<Click> last_click_;
  double last_click_s_ = 0;
};

// Moves the view so that what lies under a pixel is in its centre, around which it turns from then on. False when there
// is nothing.
bool set_centre(Session& session, glm::dvec2 pixel);

}  // namespace ryosen
