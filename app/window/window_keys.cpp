#include "app/window/window_keys.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace ryosen {

namespace {

// By its place on a US keyboard.
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
    case GLFW_KEY_END:
      return "End";
    case GLFW_KEY_PAGE_UP:
      return "PageUp";
    case GLFW_KEY_PAGE_DOWN:
      return "PageDown";
    case GLFW_KEY_TAB:
      return "Tab";
    case GLFW_KEY_SPACE:
      return "Space";
    case GLFW_KEY_DELETE:
      return "Delete";
    case GLFW_KEY_BACKSPACE:
      return "Backspace";
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER:
      return "Enter";
    case GLFW_KEY_PERIOD:
    case GLFW_KEY_KP_DECIMAL:
      return ".";
    case GLFW_KEY_KP_ADD:
    case GLFW_KEY_EQUAL:
      return "+";
    case GLFW_KEY_KP_SUBTRACT:
    case GLFW_KEY_MINUS:
      return "-";
    default:
      return {};
  }
}

bool is_on_numpad(int key) { return key >= GLFW_KEY_KP_0 && key <= GLFW_KEY_KP_EQUAL; }

// What is printed there, where keys are called so.
std::string name_printed(const char* printed) {
  const char c = printed && printed[0] != '\0' && printed[1] == '\0' ? printed[0] : '\0';
  if (c >= 'a' && c <= 'z') return std::string(1, static_cast<char>(c - 'a' + 'A'));
  if (c == '=') return "+";
  return c == '+' || c == '-' || c == '.' ? std::string(1, c) : std::string();
}

}  // namespace

std::string chord_of_glfw(int key, int modifiers, const char* printed) {
  // The right one writes letters on some keyboards.
  if (key == GLFW_KEY_LEFT_ALT) return (modifiers & (GLFW_MOD_CONTROL | GLFW_MOD_SHIFT)) == 0 ? "Alt" : "";
  std::string name = is_on_numpad(key) ? std::string() : name_printed(printed);
  if (name.empty()) name = name_of_key(key);
  if (name.empty()) return {};
  std::string chord;
  if ((modifiers & GLFW_MOD_CONTROL) != 0) chord += "Ctrl+";
  if ((modifiers & GLFW_MOD_ALT) != 0) chord += "Alt+";
  if ((modifiers & GLFW_MOD_SHIFT) != 0 && name != "+") chord += "Shift+";
  return chord + name;
}

}  // namespace ryosen
