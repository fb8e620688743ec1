// Camera navigation with the mouse; distinguishes clicks from drags.
#pragma once

#include <optional>

#include "app/editor/session.h"

namespace ryosen {

enum class MouseButton { left, right, middle };  // as numbered by GLFW and ImGui

// A click is a press and a release within this distance.
inline constexpr double click_reach_px = 4;

// Left drag orbits, right drag or Shift + left pans, middle drag orbits (Shift pans, Ctrl zooms), the wheel zooms to
// the pointer. Pixels are window pixels; the view may be anywhere in it.
class Navigation {
 public:
  struct Modifiers {
    bool shift = false, ctrl = false;
  };
  struct Click {
    glm::dvec2 pixel;
    bool is_double;  // the second of two within 0.4 s at about the same place
  };

  // A drag continues if another button is pressed; the same button restarts it.
  void press(MouseButton button, glm::dvec2 pixel, Modifiers modifiers);
  // True if the camera moved.
  bool move(Session& session, glm::dvec2 pixel);
  // Returns the click, if a left click ended.
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
    bool moved = false;  // farther than click_reach_px
  };

  std::optional<Drag> drag_;
  std::optional<Click> last_click_;
  double last_click_s_ = 0;
};

// Centres the view on the point under a pixel, which becomes the orbit target. False if there is nothing.
bool set_centre(Session& session, glm::dvec2 pixel);

}  // namespace ryosen
