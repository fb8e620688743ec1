// Work-around for GLFW up to 3.4, which aborts at the first window where a window manager has ended without taking its
// property away (glfw issue 2601).
#pragma once

namespace ryosen {

// Deletes the property _NET_SUPPORTING_WM_CHECK of the display's root where the window that it names is gone or does
// not have that property itself: no window manager runs there that could be asked. That of a running one stays. Does
// nothing without a display. Call it before glfwInit().
void forget_lost_window_manager();

}  // namespace ryosen
