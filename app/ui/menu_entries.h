// What stands in the menus of the bar.
#pragma once

#include "app/editor/preferences/menu_bar.h"

namespace ryosen {

struct PanelContext;

// The entries of a row of menu_bar, in the menu that is open.
void draw_entries(PanelContext& context, const MenuRow& menu);

}  // namespace ryosen
