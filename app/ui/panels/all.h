// The content of the panels in the columns.
#pragma once

#include "app/ui/panels.h"

namespace ryosen {

// The operators and what the pointer picks.
void draw_tools(PanelContext& context);
// What is highlighted, how it is drawn, and how much of it there is.
void draw_highlights(PanelContext& context);
// The terms of V - E + F + B - H = 2(S - G).
void draw_totals(PanelContext& context);
// What a click would do, or why it would not.
void draw_verdict(PanelContext& context);
// The selected element, or else the one under the pointer.
void draw_inspector(PanelContext& context);
// Everything that is wrong with the mesh; a click goes there.
void draw_problems(PanelContext& context);
// Every edit; a click goes back or forth to it.
void draw_history(PanelContext& context);
// The forms of the source texts side by side for this mesh, measured when the button is pressed.
void draw_forms(PanelContext& context);

}  // namespace ryosen
