// Small widgets for the panels.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "app/editor/preferences/keys.h"
#include "app/ui/panels.h"

namespace ryosen {

class Mesh;
struct Preferences;

// Text wrapped at the panel's edge, its lines as far apart as others; coloured and dim text likewise.
void wrapped_text(const char* text);
// The same at a width.
void wrapped_text(std::string_view text, float width_px);
// How large that would be, and how many lines.
ImVec2 wrapped_size(std::string_view text, float width_px);
std::size_t lines_of(std::string_view text, float width_px);
void coloured_text(const ImVec4& colour, const char* text);
void dim_text(PanelContext& context, const char* text);
// A heading, in one line.
void bold_text(PanelContext& context, const char* text);
// A dim label and a value in two columns, the second at `column` font heights or after a longer label.
void labelled(PanelContext& context, const char* label, const std::string& value, float column = 5);
// A row that looks and acts like a link; true when clicked.
bool link(PanelContext& context, const char* text);
// What a link to an element says: its name, of a halfedge its slot too, as 0-1 alone would mean its edge.
std::string link_name(const Mesh& mesh, const Element& element);
// Links to elements, wrapped at the panel's edge; a click selects one. True when one was clicked.
bool element_links(PanelContext& context, const std::vector<Element>& elements);
// A full-width row with a text on the left and a dim one on the right, that leaves some pixels free behind it, and goes
// on below for what else belongs to it; true when clicked.
bool row(PanelContext& context, const char* label, const char* right, bool is_active, float free_px = 0,
         float below_px = 0);
// How wide one is that shows both texts whole.
float row_width(const PanelContext& context, const std::string& label, const std::string& right);
// What lies below the texts of such a row, so high: marked, or lit where the pointer is; true when clicked.
bool marked_row(PanelContext& context, bool is_active, float height_px, ImGuiSelectableFlags flags = 0);
// A row with a text that is wrapped at a width, a dot before its first line, and how many lines that takes.
bool wrapped_row(PanelContext& context, std::string_view text, bool is_active, float width_px);
float lines_of_wrapped_row(PanelContext& context, std::string_view text, float width_px);
// From the top of one such row to that of the next.
float row_pitch(const PanelContext& context);
// A part of a panel as high as so many lines of text, which scrolls by whole ones; rows of another pitch say which.
// end_rows() must follow.
void begin_rows(const char* id, float rows, float width_px = 0, float pitch = 0);
// As many as fit into a height.
void begin_rows_within(const char* id, float height_px, float width_px = 0);
void end_rows(float pitch = 0);
// A list of rows, as high as there are or as these: draws those that are seen by draw(i), and scrolls to a place.
void list_of_rows(const char* id, std::size_t count, std::size_t most, const std::function<void(std::size_t)>& draw,
                  std::optional<float> scrolls_to = {}, float pitch = 0);
// Whether a letter of UTF-8 begins here.
inline bool begins_letter(char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }
// A text, or as much of it as is no wider, with an ellipsis.
std::string fitted(std::string_view text, float width_px);
std::string fitted_at_word(std::string_view text, float width_px);
// The same in so many lines.
std::string fitted_lines(std::string_view text, float width_px, std::size_t most);
// A line of text that fits the panel, up to a word, the whole beside it when it is hovered.
void fitted_text(const std::string& text, float width_px);

// Begins a panel over everything else, while Layout::open_panel names it: in the middle, or at the right where it
// leaves the view to be seen. False when there is nothing to fill; else end_over() must follow.
bool begin_over(PanelContext& context, const PanelRow& row, ImVec2 size, bool leaves_view = false);
void end_over();
// Gives the keyboard to what is drawn next, marked, without pressing it.
void give_keyboard_to_next();
// Nothing is written into and no other item is marked, as after a click beside this one.
bool is_left_alone(const char* field);

// What Enter does at a list or a check box; the space bar opens or ticks it in any case.
enum class EnterAt { opens, runs };

// Draws the field in which a value of an algorithm is typed or chosen as its row describes it, as wide as the next
// item; `text` is what it holds. True when Enter was pressed in a field of text, or at another one where that `runs`.
bool draw_parameter_field(PanelContext& context, const ParameterRow& row, std::string& text,
                          EnterAt enter = EnterAt::opens);

// The chord of the key that sends a command, or nothing.
std::string chord_of(const Preferences& preferences, std::string_view command);
std::string chord_of(std::span<const KeyRow> keys, std::string_view command);
// 34834 as 34,834.
std::string grouped(std::int64_t n);
// Six significant digits.
std::string short_number(double value);

// Tooltip of the last item, wrapped: beside the panel that it is in, so that it covers nothing of it.
void tip(std::string_view text, ImGuiHoveredFlags hovered = 0);
// The same, whether or not the pointer is at the last item.
void tip_shown(std::string_view text);

}  // namespace ryosen
