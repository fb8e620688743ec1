// Mapping of GLFW keys to the names in the key table.
#pragma once

#include <string>

namespace ryosen {

// "Ctrl+Shift+Z", "Numpad1", ".", "+"; empty for an unnamed key. `printed` is what the user's layout writes there, or
// null: letters and signs follow it, a letter of another alphabet is that of the same place on a US keyboard. A sign
// that takes Shift is the sign alone.
std::string chord_of_glfw(int key, int modifiers, const char* printed);

}  // namespace ryosen
