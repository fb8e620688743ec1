// Small widgets for the panels.
#pragma once

#include <string>
#include <string_view>

#include "app/ui/panels.h"

namespace ryosen {

// Coloured text, wrapped at the panel's edge; dim text likewise.
void coloured_text(const ImVec4& colour, const char* text);
void dim_text(PanelContext& context, const char* text);
// A dim label and a value in two columns, the second at `column` font heights or after a longer label.
void labelled(PanelContext& context, const char* label, const std::string& value, float column = 5);
// A row that looks and acts like a link; true when clicked.
bool link(PanelContext& context, const char* text);
// Links to elements, wrapped at the panel's edge; a click selects one.
void element_links(PanelContext& context, const std::vector<Element>& elements);
// A full-width row with a text on the left and a dim one on the right; true when clicked.
bool row(PanelContext& context, const char* label, const char* right, bool is_active);
// A sample of the line style and mark of a highlight, as drawn in the view.
void swatch(const Style& style, float width_px);

// A panel in the middle over everything else, while session.open_panel names it. False when there is nothing to fill;
// else end_over() must follow.
bool begin_over(PanelContext& context, const PanelRow& row, ImVec2 size);
void end_over();

// The chord of the key that sends a command, or nothing.
std::string chord_of(const Session& session, std::string_view command);
// 34834 as 34,834.
std::string grouped(std::int64_t n);
// Six significant digits.
std::string short_number(double value);

// Tooltip of the last item, wrapped.
void tip(std::string_view text, ImGuiHoveredFlags hovered = 0);

}  // namespace ryosen
