// Mapping of GLFW keys to the names in the key table.
#pragma once

#include <string>

namespace ryosen {

// "Ctrl+Shift+Z", "Numpad1", "."; empty for an unnamed key.
std::string chord_of_glfw(int key, int modifiers);

}  // namespace ryosen
