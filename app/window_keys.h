// Mapping of GLFW keys to the names in the key table.
#pragma once

#include <string>

namespace ryosen {

// "Ctrl+Shift+Z", "Numpad1", "."; empty for an unnamed key.
std::string chord_of_glfw(int key, int modifiers);

// Dear ImGui's key code for a text editing key; -1 for all others.
int imgui_key_of_glfw(int key);

}  // namespace ryosen
