// GLFW and one window with its OpenGL 3.3 context.
#pragma once

#include <array>
#include <deque>
#include <filesystem>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>

#include "app/editor/input/input.h"
#include "app/ui/gui.h"
#include "app/window/glfw.h"
#include "ryosen/base/enum_table.h"
#include "ryosen/base/result.h"
#include "ryosen/scene/view/size.h"

namespace ryosen {

// Those of a library that is loaded.
const Glfw& glfw();

// What happened to a window, as it was when it happened.
struct WindowEvent {
  enum class Kind { resized, focused, unfocused, close_asked, moved, left, button, wheel, key, character, dropped };
  enum class Way { down, again, up };

  Kind kind;
  Pointer at = {};  // where the pointer was by then, and what was held down
  MouseButton button = MouseButton::left;
  Way way = Way::down;  // of a button or a key
  double steps = 0;     // of the wheel
  std::string chord = {};
  unsigned character = 0;
  std::filesystem::path path = {};
};

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
  // The shape of the pointer over it.
  void show_pointer(PointerShape shape);
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
  PointerShape shown_pointer_ = PointerShape::arrow;
  std::array<GLFWcursor*, enum_count<PointerShape>> cursors_{};  // those made so far, which go with GLFW
};

}  // namespace ryosen
