// What stands in the menus of the bar.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/editor/preferences/menu_bar.h"
#include "ryosen/base/message.h"

namespace ryosen {

struct PanelContext;

// The entries of a row of menu_bar, in the menu that is open.
void draw_entries(PanelContext& context, const MenuRow& menu);

// Calls under one title in a menu: the name and the line of each.
struct OfferedCalls {
  Text title;
  std::vector<std::pair<Text, std::string>> calls;
};
// Scripts of the source texts: textbook/offered.cpp
std::vector<OfferedCalls> textbook_calls();

}  // namespace ryosen
