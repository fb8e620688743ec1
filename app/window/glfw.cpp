#include "app/window/glfw.h"

#include <dlfcn.h>

#include <optional>

namespace ryosen {

namespace {

std::optional<Glfw> loaded() {
  void* const library = dlopen("libglfw.so.3", RTLD_NOW | RTLD_LOCAL);
  if (!library) return std::nullopt;
  Glfw glfw;
  bool is_complete = true;
  const auto find = [&]<class Function>(Function& function, const char* name) {
    function = reinterpret_cast<Function>(dlsym(library, name));
    is_complete = is_complete && function;
  };
  find(glfw.create_standard_cursor, "glfwCreateStandardCursor");
  find(glfw.create_window, "glfwCreateWindow");
  find(glfw.destroy_window, "glfwDestroyWindow");
  find(glfw.get_cursor_pos, "glfwGetCursorPos");
  find(glfw.get_clipboard_string, "glfwGetClipboardString");
  find(glfw.get_error, "glfwGetError");
  find(glfw.get_framebuffer_size, "glfwGetFramebufferSize");
  find(glfw.get_key, "glfwGetKey");
  find(glfw.get_key_name, "glfwGetKeyName");
  find(glfw.get_monitor_content_scale, "glfwGetMonitorContentScale");
  find(glfw.get_monitor_workarea, "glfwGetMonitorWorkarea");
  find(glfw.get_primary_monitor, "glfwGetPrimaryMonitor");
  find(glfw.get_proc_address, "glfwGetProcAddress");
  find(glfw.get_time, "glfwGetTime");
  find(glfw.get_window_content_scale, "glfwGetWindowContentScale");
  find(glfw.get_window_size, "glfwGetWindowSize");
  find(glfw.get_window_user_pointer, "glfwGetWindowUserPointer");
  find(glfw.init, "glfwInit");
  find(glfw.make_context_current, "glfwMakeContextCurrent");
  find(glfw.set_char_callback, "glfwSetCharCallback");
  find(glfw.set_clipboard_string, "glfwSetClipboardString");
  find(glfw.set_cursor, "glfwSetCursor");
  find(glfw.set_cursor_enter_callback, "glfwSetCursorEnterCallback");
  find(glfw.set_cursor_pos_callback, "glfwSetCursorPosCallback");
  find(glfw.set_drop_callback, "glfwSetDropCallback");
  find(glfw.set_framebuffer_size_callback, "glfwSetFramebufferSizeCallback");
  find(glfw.set_key_callback, "glfwSetKeyCallback");
  find(glfw.set_mouse_button_callback, "glfwSetMouseButtonCallback");
  find(glfw.set_scroll_callback, "glfwSetScrollCallback");
  find(glfw.set_window_close_callback, "glfwSetWindowCloseCallback");
  find(glfw.set_window_content_scale_callback, "glfwSetWindowContentScaleCallback");
  find(glfw.set_window_focus_callback, "glfwSetWindowFocusCallback");
  find(glfw.set_window_refresh_callback, "glfwSetWindowRefreshCallback");
  find(glfw.set_window_should_close, "glfwSetWindowShouldClose");
  find(glfw.set_window_title, "glfwSetWindowTitle");
  find(glfw.set_window_user_pointer, "glfwSetWindowUserPointer");
  find(glfw.swap_buffers, "glfwSwapBuffers");
  find(glfw.swap_interval, "glfwSwapInterval");
  find(glfw.terminate, "glfwTerminate");
  find(glfw.poll_events, "glfwPollEvents");
  find(glfw.wait_events, "glfwWaitEvents");
  find(glfw.wait_events_timeout, "glfwWaitEventsTimeout");
  find(glfw.window_hint, "glfwWindowHint");
  return is_complete ? std::optional(glfw) : std::nullopt;
}

}  // namespace

const Glfw* load_glfw() {
  static const std::optional<Glfw> glfw = loaded();
  return glfw ? &*glfw : nullptr;
}

}  // namespace ryosen
