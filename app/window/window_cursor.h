// The shape of the pointer over a window.
#pragma once

#include <array>

#include "app/ui/gui.h"
#include "app/window/glfw.h"
#include "ryosen/base/enum_table.h"

namespace ryosen {

class WindowCursor {
 public:
  // Only after load_glfw() has succeeded and glfwInit; what it makes goes with GLFW.
  void show(GLFWwindow* window, PointerShape shape);

 private:
  PointerShape shown_ = PointerShape::arrow;
  std::array<GLFWcursor*, enum_count<PointerShape>> made_{};
};

}  // namespace ryosen
