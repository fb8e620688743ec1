// Menus of the window: what others put into those of the bar, and a menu within a menu.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "ryosen/base/message.h"

namespace ryosen {

// Calls under one title in a menu: the name and the line of each.
struct OfferedCalls {
  Text title;
  std::vector<std::pair<Text, std::string>> calls;
};
// Scripts of the source texts: textbook/offered.cpp
std::vector<OfferedCalls> textbook_calls();

// As ImGui::BeginMenu(); EndMenu() must follow where it is open. Where there is no room beside the menu around, it lies
// over the ends of the entries, with their keys and arrows, and not over their names.
bool begin_submenu(const char* name, bool is_enabled = true);

}  // namespace ryosen
