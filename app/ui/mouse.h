// Mouse dispatch in a window with panels. A press goes to what is under the pointer, the view or the panels; its
// release goes to both, so whichever has the button releases it, wherever the pointer is by then.
#pragma once

#include "app/ui/gui.h"
#include "app/editor/navigation.h"

namespace ryosen {

// Pixels are window pixels. The gui and the session must outlive it.
class Mouse {
 public:
  Mouse(Gui& gui, Session& session) : gui_(gui), session_(session) {}

  void press(MouseButton button, glm::dvec2 pixel, Navigation::Modifiers modifiers, Size window);
  void release(MouseButton button, glm::dvec2 pixel, double now_s, Size window);
  void move(glm::dvec2 pixel, Size window);
  void wheel(double steps, glm::dvec2 pixel, Size window);
  // Hovers the element under the pixel. Over a panel the last element stays hovered, so that its information there can
  // be read and clicked.
  void point(glm::dvec2 pixel, Size window);
  // The pointer has left the window. A drag goes on.
  void leave();
  // The window has lost focus and will miss releases: ends every press, without a click.
  void let_go();

  bool is_dragging() const { return navigation_.is_dragging(); }

 private:
  bool is_over_view(glm::dvec2 pixel, Size window) const { return !gui_.owns_pointer(session_, window, pixel); }

  Gui& gui_;
  Session& session_;
  Navigation navigation_;
};

}  // namespace ryosen
