// GLFW, loaded at run time for the first window: commands without a window neither need nor load it.
#pragma once

#include <string>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace ryosen {

// The library functions used by the window, named without their prefix.
struct Glfw {
  decltype(&glfwCreateStandardCursor) create_standard_cursor = nullptr;
  decltype(&glfwCreateWindow) create_window = nullptr;
  decltype(&glfwDestroyWindow) destroy_window = nullptr;
  decltype(&glfwGetCursorPos) get_cursor_pos = nullptr;
  decltype(&glfwGetClipboardString) get_clipboard_string = nullptr;
  decltype(&glfwGetError) get_error = nullptr;
  decltype(&glfwGetFramebufferSize) get_framebuffer_size = nullptr;
  decltype(&glfwGetKey) get_key = nullptr;
  decltype(&glfwGetKeyName) get_key_name = nullptr;
  decltype(&glfwGetMonitorContentScale) get_monitor_content_scale = nullptr;
  decltype(&glfwGetMonitorWorkarea) get_monitor_workarea = nullptr;
  decltype(&glfwGetPrimaryMonitor) get_primary_monitor = nullptr;
  decltype(&glfwGetProcAddress) get_proc_address = nullptr;
  decltype(&glfwGetTime) get_time = nullptr;
  decltype(&glfwGetWindowContentScale) get_window_content_scale = nullptr;
  decltype(&glfwGetWindowSize) get_window_size = nullptr;
  decltype(&glfwGetWindowUserPointer) get_window_user_pointer = nullptr;
  decltype(&glfwInit) init = nullptr;
  decltype(&glfwMakeContextCurrent) make_context_current = nullptr;
  decltype(&glfwSetCharCallback) set_char_callback = nullptr;
  decltype(&glfwSetClipboardString) set_clipboard_string = nullptr;
  decltype(&glfwSetCursor) set_cursor = nullptr;
  decltype(&glfwSetCursorEnterCallback) set_cursor_enter_callback = nullptr;
  decltype(&glfwSetCursorPosCallback) set_cursor_pos_callback = nullptr;
  decltype(&glfwSetDropCallback) set_drop_callback = nullptr;
  decltype(&glfwSetFramebufferSizeCallback) set_framebuffer_size_callback = nullptr;
  decltype(&glfwSetKeyCallback) set_key_callback = nullptr;
  decltype(&glfwSetMouseButtonCallback) set_mouse_button_callback = nullptr;
  decltype(&glfwSetScrollCallback) set_scroll_callback = nullptr;
  decltype(&glfwSetWindowCloseCallback) set_window_close_callback = nullptr;
  decltype(&glfwSetWindowContentScaleCallback) set_window_content_scale_callback = nullptr;
  decltype(&glfwSetWindowFocusCallback) set_window_focus_callback = nullptr;
  decltype(&glfwSetWindowRefreshCallback) set_window_refresh_callback = nullptr;
  decltype(&glfwSetWindowShouldClose) set_window_should_close = nullptr;
  decltype(&glfwSetWindowTitle) set_window_title = nullptr;
  decltype(&glfwSetWindowUserPointer) set_window_user_pointer = nullptr;
  decltype(&glfwSwapBuffers) swap_buffers = nullptr;
  decltype(&glfwSwapInterval) swap_interval = nullptr;
  decltype(&glfwTerminate) terminate = nullptr;
  decltype(&glfwPollEvents) poll_events = nullptr;
  decltype(&glfwWaitEvents) wait_events = nullptr;
  decltype(&glfwWaitEventsTimeout) wait_events_timeout = nullptr;
  decltype(&glfwWindowHint) window_hint = nullptr;
};

// Null if the library or one of its functions is missing. It stays loaded.
const Glfw* load_glfw();

}  // namespace ryosen
