#include "app/window_keys.h"

#include <imgui.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace ryosen {

namespace {

std::string name_of_key(int key) {
  if ((key >= GLFW_KEY_A && key <= GLFW_KEY_Z) || (key >= GLFW_KEY_0 && key <= GLFW_KEY_9))
    return std::string(1, static_cast<char>(key));
  if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12) return "F" + std::to_string(key - GLFW_KEY_F1 + 1);
  if (key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_9) return "Numpad" + std::to_string(key - GLFW_KEY_KP_0);
  switch (key) {
    case GLFW_KEY_ESCAPE:
      return "Escape";
    case GLFW_KEY_LEFT:
      return "Left";
    case GLFW_KEY_RIGHT:
      return "Right";
    case GLFW_KEY_UP:
      return "Up";
    case GLFW_KEY_DOWN:
      return "Down";
    case GLFW_KEY_HOME:
      return "Home";
    case GLFW_KEY_PERIOD:
    case GLFW_KEY_KP_DECIMAL:
      return ".";
    default:
      return {};
  }
}

}  // namespace

std::string chord_of_glfw(int key, int modifiers) {
  const std::string name = name_of_key(key);
  if (name.empty()) return {};
  std::string chord;
  if ((modifiers & GLFW_MOD_CONTROL) != 0) chord += "Ctrl+";
  if ((modifiers & GLFW_MOD_ALT) != 0) chord += "Alt+";
  if ((modifiers & GLFW_MOD_SHIFT) != 0) chord += "Shift+";
  return chord + name;
}

int imgui_key_of_glfw(int key) {
  switch (key) {
    case GLFW_KEY_TAB:
      return ImGuiKey_Tab;
    case GLFW_KEY_LEFT:
      return ImGuiKey_LeftArrow;
    case GLFW_KEY_RIGHT:
      return ImGuiKey_RightArrow;
    case GLFW_KEY_UP:
      return ImGuiKey_UpArrow;
    case GLFW_KEY_DOWN:
      return ImGuiKey_DownArrow;
    case GLFW_KEY_HOME:
      return ImGuiKey_Home;
    case GLFW_KEY_END:
      return ImGuiKey_End;
    case GLFW_KEY_DELETE:
      return ImGuiKey_Delete;
    case GLFW_KEY_BACKSPACE:
      return ImGuiKey_Backspace;
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER:
      return ImGuiKey_Enter;
    case GLFW_KEY_ESCAPE:
      return ImGuiKey_Escape;
    case GLFW_KEY_A:
      return ImGuiKey_A;
    case GLFW_KEY_C:
      return ImGuiKey_C;
    case GLFW_KEY_V:
      return ImGuiKey_V;
    case GLFW_KEY_X:
      return ImGuiKey_X;
    case GLFW_KEY_Z:
      return ImGuiKey_Z;
    default:
      return -1;
  }
}

}  // namespace ryosen
