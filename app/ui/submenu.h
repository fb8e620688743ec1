// A menu within a menu, beside it also in a window with little room.
#pragma once

namespace ryosen {

// As ImGui::BeginMenu(); EndMenu() must follow where it is open. Where there is no room beside the menu around, it lies
// over the ends of the entries, with their keys and arrows, and not over their names.
bool begin_submenu(const char* name, bool is_enabled = true);

}  // namespace ryosen
