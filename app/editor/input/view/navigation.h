// Camera navigation with the mouse; distinguishes clicks from drags.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "app/editor/input/input_presets.h"

namespace ryosen {

class Session;

// A click is a press and a release within this distance, at scale 1.
inline constexpr double click_reach_px = 4;

// Moves the camera by drags and the wheel. A drag of the camera holds on to the point of the mesh under the press: to
// orbit turns about it, to pan keeps it under the pointer. The wheel brings the eye towards the point under the
// pointer by a share of its distance. Where there is none, orbiting turns about the target, and the others act as
// deep as the nearest of the surface that is seen, or as the target. Pixels are those of the window; the view may be
// anywhere in it.
class Navigation {
 public:
  struct Click {
    MouseButton button;
    glm::dvec2 pixel;
    Modifiers modifiers;  // of the press
    bool is_double;       // the second of two within 0.4 s at about the same place, without Shift, Ctrl and Alt
  };

  // A drag continues if another button is pressed; the same button restarts it. `scale`: of the display, by which a
  // click reaches farther.
  void press(MouseButton button, glm::dvec2 pixel, Modifiers modifiers, DragAction action, double scale = 1);
  // True if it is a drag: the camera moved, or the band of the session grew.
  bool move(Session& session, glm::dvec2 pixel);
  // Returns the click, if a left or right click ended.
  std::optional<Click> release(MouseButton button, glm::dvec2 pixel, double now_s);
  void wheel(Session& session, glm::dvec2 pixel, double steps) const;
  // Forgets the drag and the last click.
  void cancel();
  // The next click is no second one.
  void forget_click() { last_click_.reset(); }

  bool is_dragging() const { return drag_.has_value(); }

 private:
  struct Drag {
    MouseButton button;
    DragAction action;
    Modifiers modifiers;
    glm::dvec2 start, last;
    double reach_px;
    bool moved = false;  // farther than that
    glm::dvec3 held{0};  // set when it has moved
  };

  std::optional<Drag> drag_;
  std::optional<Click> last_click_;
  double last_click_s_ = 0;
};

// Centres the view on the point of the mesh under a pixel, which becomes the target; the eye moves parallel to the
// view. False if there is nothing.
bool set_centre(Session& session, glm::dvec2 pixel);

}  // namespace ryosen
