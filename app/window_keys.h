// Names of GLFW's keys, as the table of keys has them.
#pragma once

#include <string>

namespace ryosen {

// "Ctrl+Shift+Z", "Numpad1", "."; empty for a key that no table names.
std::string chord_of_glfw(int key, int modifiers);

// Dear ImGui's number of a key that edits text; -1 for all others.
int imgui_key_of_glfw(int key);

}  // namespace ryosen
