#include "app/ui/mouse.h"

namespace ryosen {

void Mouse::press(MouseButton button, glm::dvec2 pixel, Navigation::Modifiers modifiers, Size window) {
  if (is_over_view(pixel, window))
    navigation_.press(button, pixel, modifiers);
  else
    gui_.button(static_cast<int>(button), true);
}

void Mouse::release(MouseButton button, glm::dvec2 pixel, double now_s, Size window) {
  gui_.button(static_cast<int>(button), false);
  const auto click = navigation_.release(button, pixel, now_s);
  // A panel may have been opened since the press.
  if (click && is_over_view(click->pixel, window)) {
    if (click->is_double && session_.tool.empty())  // with a tool two quick clicks are two edits
      set_centre(session_, click->pixel);
    else
      gui_.click(session_, click->pixel);
  }
  point(pixel, window);
}

void Mouse::move(glm::dvec2 pixel, Size window) {
  gui_.pointer(pixel);
  if (navigation_.move(session_, pixel))
    session_.point_away();
  else
    point(pixel, window);
}

void Mouse::wheel(double steps, glm::dvec2 pixel, Size window) {
  if (!is_over_view(pixel, window)) return gui_.wheel(steps);
  navigation_.wheel(session_, pixel, steps);
  point(pixel, window);
}

void Mouse::point(glm::dvec2 pixel, Size window) {
  if (!navigation_.is_dragging() && is_over_view(pixel, window)) session_.point_at(pixel);
}

void Mouse::leave() {
  gui_.pointer({-1e9, -1e9});
  session_.point_away();
}

void Mouse::let_go() {
  navigation_.cancel();
  for (const MouseButton button : {MouseButton::left, MouseButton::right, MouseButton::middle})
    gui_.button(static_cast<int>(button), false);
}

}  // namespace ryosen
