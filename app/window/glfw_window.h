// GLFW and one window with its OpenGL 3.3 context.
#pragma once

#include <deque>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>

#include "app/window/glfw.h"
#include "app/window/window_event.h"
#include "ryosen/base/result.h"
#include "ryosen/scene/view/size.h"

namespace ryosen {

// Those of a library that is loaded.
const Glfw& glfw();

// The context is current on the thread that made the window. What happens to the window waits until it is taken: GLFW's
// callbacks only note it, since what an event asks for may be long and wants to show its progress, which no callback
// may.
class GlfwWindow {
 public:
  // Fails with ExitCode::no_backend.
  static Result<std::unique_ptr<GlfwWindow>> make();
  ~GlfwWindow();
  GlfwWindow(const GlfwWindow&) = delete;
  GlfwWindow& operator=(const GlfwWindow&) = delete;

  GLFWwindow* handle() const { return handle_; }
  Size size() const;
  float scale() const;
  // Another window was before it: what it showed is to be shown again. Once.
  bool take_exposure();
  // The first event that has not been taken yet; in the order in which they came in.
  std::optional<WindowEvent> take_event();
  // Whether there is one, of those too that come in just now.
  bool has_event();

 private:
  GlfwWindow() = default;
  static GlfwWindow& of(GLFWwindow* window) {
    return *static_cast<GlfwWindow*>(glfw().get_window_user_pointer(window));
  }
  void set_callbacks();
  void note(WindowEvent event);
  void note_key(int key, int place, int action, int modifiers);
  // GLFW gives screen coordinates, which may be coarser than pixels.
  glm::dvec2 to_pixels(double x, double y) const;
  Pointer pointer() const;

  GLFWwindow* handle_ = nullptr;
  // Where the last event has put the pointer. It may be elsewhere by now: a press belongs to where it was made, however
  // many events are waiting behind it.
  glm::dvec2 pointer_px_{0};
  std::deque<WindowEvent> events_;
  bool is_up_ = false, is_exposed_ = true;
};

}  // namespace ryosen
