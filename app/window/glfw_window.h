// GLFW, loaded at run time for the first window, and one window with its OpenGL 3.3 context. Commands without a window
// neither need nor load it.
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
#include "render/context/library.h"
#include "ryosen/base/enum_table.h"
#include "ryosen/base/result.h"
#include "ryosen/scene/view/size.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace ryosen {

// The library functions used by the window, named without their prefix.
struct Glfw {
  LoadedLibrary library = open_library({"libglfw.so.3"});
  decltype(&glfwCreateStandardCursor) create_standard_cursor = library.find("glfwCreateStandardCursor");
  decltype(&glfwCreateWindow) create_window = library.find("glfwCreateWindow");
  decltype(&glfwDestroyWindow) destroy_window = library.find("glfwDestroyWindow");
  decltype(&glfwGetCursorPos) get_cursor_pos = library.find("glfwGetCursorPos");
  decltype(&glfwGetClipboardString) get_clipboard_string = library.find("glfwGetClipboardString");
  decltype(&glfwGetError) get_error = library.find("glfwGetError");
  decltype(&glfwGetFramebufferSize) get_framebuffer_size = library.find("glfwGetFramebufferSize");
  decltype(&glfwGetKey) get_key = library.find("glfwGetKey");
  decltype(&glfwGetKeyName) get_key_name = library.find("glfwGetKeyName");
  decltype(&glfwGetMonitorContentScale) get_monitor_content_scale = library.find("glfwGetMonitorContentScale");
  decltype(&glfwGetMonitorWorkarea) get_monitor_workarea = library.find("glfwGetMonitorWorkarea");
  decltype(&glfwGetPrimaryMonitor) get_primary_monitor = library.find("glfwGetPrimaryMonitor");
  decltype(&glfwGetProcAddress) get_proc_address = library.find("glfwGetProcAddress");
  decltype(&glfwGetTime) get_time = library.find("glfwGetTime");
  decltype(&glfwGetWindowContentScale) get_window_content_scale = library.find("glfwGetWindowContentScale");
  decltype(&glfwGetWindowSize) get_window_size = library.find("glfwGetWindowSize");
  decltype(&glfwGetWindowUserPointer) get_window_user_pointer = library.find("glfwGetWindowUserPointer");
  decltype(&glfwInit) init = library.find("glfwInit");
  decltype(&glfwMakeContextCurrent) make_context_current = library.find("glfwMakeContextCurrent");
  decltype(&glfwSetCharCallback) set_char_callback = library.find("glfwSetCharCallback");
  decltype(&glfwSetClipboardString) set_clipboard_string = library.find("glfwSetClipboardString");
  decltype(&glfwSetCursor) set_cursor = library.find("glfwSetCursor");
  decltype(&glfwSetCursorEnterCallback) set_cursor_enter_callback = library.find("glfwSetCursorEnterCallback");
  decltype(&glfwSetCursorPosCallback) set_cursor_pos_callback = library.find("glfwSetCursorPosCallback");
  decltype(&glfwSetDropCallback) set_drop_callback = library.find("glfwSetDropCallback");
  decltype(&glfwSetFramebufferSizeCallback) set_framebuffer_size_callback =
      library.find("glfwSetFramebufferSizeCallback");
  decltype(&glfwSetKeyCallback) set_key_callback = library.find("glfwSetKeyCallback");
  decltype(&glfwSetMouseButtonCallback) set_mouse_button_callback = library.find("glfwSetMouseButtonCallback");
  decltype(&glfwSetScrollCallback) set_scroll_callback = library.find("glfwSetScrollCallback");
  decltype(&glfwSetWindowCloseCallback) set_window_close_callback = library.find("glfwSetWindowCloseCallback");
  decltype(&glfwSetWindowContentScaleCallback) set_window_content_scale_callback =
      library.find("glfwSetWindowContentScaleCallback");
  decltype(&glfwSetWindowFocusCallback) set_window_focus_callback = library.find("glfwSetWindowFocusCallback");
  decltype(&glfwSetWindowRefreshCallback) set_window_refresh_callback = library.find("glfwSetWindowRefreshCallback");
  decltype(&glfwSetWindowShouldClose) set_window_should_close = library.find("glfwSetWindowShouldClose");
  decltype(&glfwSetWindowTitle) set_window_title = library.find("glfwSetWindowTitle");
  decltype(&glfwSetWindowUserPointer) set_window_user_pointer = library.find("glfwSetWindowUserPointer");
  decltype(&glfwSwapBuffers) swap_buffers = library.find("glfwSwapBuffers");
  decltype(&glfwSwapInterval) swap_interval = library.find("glfwSwapInterval");
  decltype(&glfwTerminate) terminate = library.find("glfwTerminate");
  decltype(&glfwPollEvents) poll_events = library.find("glfwPollEvents");
  decltype(&glfwWaitEventsTimeout) wait_events_timeout = library.find("glfwWaitEventsTimeout");
  decltype(&glfwWindowHint) window_hint = library.find("glfwWindowHint");
};

// Null if the library or one of its functions is missing. It stays loaded.
inline const Glfw* load_glfw() {
  static const Glfw glfw;
  return glfw.library.lacks ? nullptr : &glfw;
}

// The functions of a library that is loaded.
inline const Glfw& glfw() { return *load_glfw(); }

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
