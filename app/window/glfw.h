// GLFW, loaded at run time for the first window: commands without a window neither need nor load it.
#pragma once

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "render/context/library.h"

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
  decltype(&glfwWaitEvents) wait_events = library.find("glfwWaitEvents");
  decltype(&glfwWaitEventsTimeout) wait_events_timeout = library.find("glfwWaitEventsTimeout");
  decltype(&glfwWindowHint) window_hint = library.find("glfwWindowHint");
};

// Null if the library or one of its functions is missing. It stays loaded.
inline const Glfw* load_glfw() {
  static const Glfw glfw;
  return glfw.library.lacks ? nullptr : &glfw;
}

}  // namespace ryosen
