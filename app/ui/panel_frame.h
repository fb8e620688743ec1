// A panel of a column with its header: a click on that folds it, and its menu hides it or puts it on the other side.
#pragma once

#include <memory>

#include "app/ui/panels.h"

namespace ryosen {

// A panel of the window, with its row.
struct OwnPanel {
  PanelRow row;
  std::unique_ptr<Panel> panel;
  std::unique_ptr<ScopedPanel> added;  // null for those of the list
  bool was_over = false;               // drawn over the view in the last frame
  float begins_px = 0;                 // from there on it covers the view, where it leaves that to be seen
};

// What a click on the header does.
enum class HeaderClick { folds, closes };

// Its header alone, once more, where the panel's own is out of sight.
void draw_panel_header(PanelContext& context, const PanelRow& row);
void draw_framed(PanelContext& context, OwnPanel& own, HeaderClick header);

}  // namespace ryosen
