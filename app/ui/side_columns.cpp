#include "app/ui/side_columns.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/editor/document/findings.h"
#include "app/editor/preferences/layout.h"
#include "app/ui/style.h"
#include "app/ui/widgets.h"

namespace ryosen {

namespace {

// At scale 1.
constexpr int least_window_px = 900;  // that has columns
constexpr int least_view_px = 200;
constexpr float tabs_px = 30;  // the width of a strip

int scaled(float px, float scale) { return static_cast<int>(std::lround(px * scale)); }

// The height of ImGui's menu bar, and of the status line: font size plus vertical padding.
int bar_px(const UiSize& size) {
  return static_cast<int>(std::round(static_cast<float>(size.font_px) * size.scale) +
                          2 * std::floor(frame_padding_px * size.scale));
}

// The widest that a column of a window may be made by hand, at scale 1.
int widest_column_px(const Layout& layout, PanelPlace side, Size window, float column_scale) {
  const PanelPlace other = side == PanelPlace::left ? PanelPlace::right : PanelPlace::left;
  const int taken = layout.is_empty(other) ? 0 : layout.width_px(other);
  const auto room = static_cast<int>(static_cast<float>(window.width) / column_scale) - taken - least_view_px;
  return std::clamp(room, least_column_px, most_column_px);
}

constexpr float border_px = 5;  // that can be taken hold of, at scale 1

constexpr ImGuiWindowFlags column_flags =
    ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoFocusOnAppearing;

// The border between a column and the view; a drag makes the column wider or narrower.
void draw_border(PanelContext& context, PanelPlace side, const PixelRect& column) {
  const bool is_left = side == PanelPlace::left;
  const float width = std::round(border_px * context.scale);
  const ImVec2 at{is_left ? static_cast<float>(column.x1) - width : static_cast<float>(column.x0),
                  static_cast<float>(column.y0)};
  const ImVec2 size{width, static_cast<float>(std::max(column.height(), 1))};
  ImGui::SetNextWindowPos(at);
  ImGui::SetNextWindowSize(size);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  ImGui::Begin(is_left ? "##left border" : "##right border", nullptr, column_flags | ImGuiWindowFlags_NoScrollbar);
  ImGui::PopStyleVar(3);
  ImGui::InvisibleButton("border", size);
  const bool is_held = ImGui::IsItemActive();
  if (is_held || ImGui::IsItemHovered()) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    const float line = std::max(2 * context.scale, 1.f), x = is_left ? at.x + width - line : at.x;
    ImGui::GetWindowDrawList()->AddRectFilled({x, at.y}, {x + line, at.y + size.y},
                                              ImGui::GetColorU32(context.colours().accent));
  }
  if (is_held && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 1)) {
    const ImVec2 all = ImGui::GetIO().DisplaySize;
    const float pointed = is_left ? ImGui::GetIO().MousePos.x : all.x - ImGui::GetIO().MousePos.x;
    const Size window{static_cast<int>(all.x), static_cast<int>(all.y)};
    const int widest = widest_column_px(context.layout, side, window, context.column_scale);
    const float px = std::clamp(pointed / context.column_scale, float{least_column_px}, static_cast<float>(widest));
    const int wanted = static_cast<int>(std::lround(px));
    if (wanted != context.layout.width_px(side))
      context.run(std::string("columns ") + (is_left ? "left " : "right ") + std::to_string(wanted));
  }
  ImGui::End();
}

// The names of the windows: the columns, and what lies over the upper end of one.
struct ColumnNames {
  const char *column, *covering;
};
constexpr ColumnNames names[2] = {{"##left", "##left/held"}, {"##right", "##right/held"}};

// What a click on the header of a panel does.
enum class HeaderClick { folds, closes };

// Three dots, which not every font has.
void draw_dots(PanelContext& context, ImVec2 from, ImVec2 size) {
  const float radius = 1.4f * context.scale, apart = 4.5f * context.scale;
  const ImVec2 middle{from.x + size.x / 2, from.y + size.y / 2};
  const ImU32 colour = ImGui::GetColorU32(ImGui::IsItemHovered() ? ImGuiCol_Text : ImGuiCol_TextDisabled);
  for (const float at : {-apart, 0.f, apart})
    ImGui::GetWindowDrawList()->AddCircleFilled({middle.x + at, middle.y}, radius, colour);
}

void draw_menu_of(PanelContext& context, const PanelRow& row, HeaderClick header) {
  if (!ImGui::BeginPopup("menu")) return;
  const Layout& layout = context.layout;
  const std::string panel = "panel " + std::string(row.id);
  const bool is_folded = layout.is_folded(row), is_left = layout.side_of(row) == PanelPlace::left;
  const auto entry = [&](UiText name, const char* word) {
    if (ImGui::MenuItem(context.text(name))) context.run(panel + word);
  };
  if (header == HeaderClick::folds)
    entry(is_folded ? UiText::panel_unfold : UiText::panel_fold, is_folded ? " unfold" : " fold");
  entry(is_left ? UiText::panel_to_right : UiText::panel_to_left, is_left ? " right" : " left");
  entry(UiText::panel_hide, " off");
  tip(context.text(UiText::panel_hide_help));
  ImGui::EndPopup();
}

// The header of a panel: a click folds it, and its menu hides it or puts it on the other side. True while the panel is
// unfolded.
bool draw_header(PanelContext& context, const PanelRow& row, HeaderClick header) {
  const std::string panel = "panel " + std::string(row.id);
  const bool was_open = header == HeaderClick::closes || !context.layout.is_folded(row);
  const ImVec2 button{ImGui::GetFrameHeight() + 4 * context.scale, ImGui::GetFrameHeight()};
  const float room = ImGui::GetContentRegionAvail().x - 2 * button.x;
  ImGui::SetNextItemOpen(was_open);
  ImGui::PushFont(context.fonts.bold);
  const std::string title = fitted(context.title(row), room);
  const bool is_open = ImGui::CollapsingHeader((title + "###header").c_str(), ImGuiTreeNodeFlags_AllowItemOverlap);
  ImGui::PopFont();
  if (!row.help_en.empty()) tip(context.text(row.help_en, row.help_ja));
  if (is_open != was_open)
    context.run(header == HeaderClick::closes ? "panel none" : panel + (is_open ? " unfold" : " fold"));
  bool wants_menu = ImGui::IsItemClicked(ImGuiMouseButton_Right);
  const ImVec2 corner{ImGui::GetItemRectMax().x - button.x, ImGui::GetItemRectMin().y};
  const ImVec2 below = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(corner);
  wants_menu |= ImGui::InvisibleButton("dots", button);
  draw_dots(context, corner, button);
  tip(context.text(UiText::panel_menu));
  ImGui::SetCursorScreenPos(below);
  if (wants_menu) ImGui::OpenPopup("menu");
  draw_menu_of(context, row, header);
  return is_open;
}

void draw_body(PanelContext& context, OwnPanel& own) {
  const float lines = own.panel->lines();
  if (lines > 0) begin_rows("fixed", lines);
  const auto share = context.findings().preparing();
  if (share && own.row.reads == PanelReads::findings)
    draw_preparing(context, *share);
  else
    own.panel->draw(context);
  if (lines > 0) end_rows();
}

// The header alone, once more, where the panel's own is out of sight.
void draw_panel_header(PanelContext& context, const PanelRow& row) {
  ImGui::PushID(row.id.data(), row.id.data() + row.id.size());
  draw_header(context, row, HeaderClick::folds);
  ImGui::PopID();
}

void draw_framed(PanelContext& context, OwnPanel& own, HeaderClick header) {
  ImGui::PushID(own.row.id.data(), own.row.id.data() + own.row.id.size());
  if (draw_header(context, own.row, header)) {
    draw_body(context, own);
    if (std::exchange(context.state.asks_to_be_seen, false)) context.layout.wanted = own.row.id;
    ImGui::SetCursorPosY(ImGui::GetCursorPosY() + 3 * context.scale);
  }
  ImGui::PopID();
}

// Of the window that is drawn.
SeenPart seen_part(const ColumnNames& of, float covered_px) {
  const float top = ImGui::GetWindowPos().y, border = ImGui::GetStyle().WindowBorderSize;
  return {of.column, of.covering, top + covered_px, top + ImGui::GetWindowSize().y - border};
}

bool lies_in(const PanelContext& context, const PanelRow& row, PanelPlace side) {
  return row.place != PanelPlace::over && context.layout.side_of(row) == side && context.layout.is_shown(row);
}

}  // namespace

float UiSize::of_columns() const {
  return scale * std::max(1.f, static_cast<float>(font_px) / static_cast<float>(UiSize().font_px));
}

Areas areas_of(const Layout& layout, Size window, const UiSize& size) {
  const float scale = size.of_columns();
  Areas areas;
  areas.has_tabs = static_cast<float>(window.width) < least_window_px * scale;
  const int bar = bar_px(size);
  const auto width = [&](PanelPlace side) {
    if (layout.is_empty(side)) return 0;
    if (!areas.has_tabs) return scaled(static_cast<float>(layout.width_px(side)), scale);
    return scaled(tabs_px, scale);
  };
  int left = width(PanelPlace::left), right = width(PanelPlace::right);
  const int room = std::max(window.width - scaled(least_view_px, scale), 0);
  if (!areas.has_tabs && left + right > room) {
    left = static_cast<int>(std::int64_t{left} * room / (left + right));
    right = std::min(right, room - left);
  }
  areas.view = {left, bar, window.width - right, window.height - bar};
  areas.view.x1 = std::max(areas.view.x1, areas.view.x0 + 1);
  areas.view.y1 = std::max(areas.view.y1, areas.view.y0 + 1);
  areas.left = {0, bar, areas.view.x0, areas.view.y1};
  areas.right = {areas.view.x1, bar, window.width, areas.view.y1};
  return areas;
}

const char* column_window(PanelPlace side) { return names[side == PanelPlace::left ? 0 : 1].column; }

// Over the upper end of a column that is scrolled; drawn after all else that lies in it, so that it is seen. What is
// seen below it begins with the header of its own panel, where that has been scrolled away.
void SideColumns::draw_over(PanelContext& context, OwnPanel& own, float begin, float& height_px,
                            const PanelRow* below) {
  const float x = ImGui::GetCursorPosX(), end = ImGui::GetCursorPosY();
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {x, begin});
  ImGui::SetCursorPos({0, ImGui::GetScrollY()});
  ImGui::BeginChild(
      "held",
      {x + ImGui::GetWindowContentRegionMax().x, begin + height_px + (below ? ImGui::GetFrameHeightWithSpacing() : 0)},
      false,
      ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_AlwaysUseWindowPadding);
  ImGui::PopStyleVar();
  const ImVec2 from = ImGui::GetWindowPos(), size = ImGui::GetWindowSize(), to{from.x + size.x, from.y + size.y};
  const float line = std::max(context.scale, 1.f), end_of_own = from.y + begin + height_px;
  ImGui::GetWindowDrawList()->AddRectFilled(from, to, ImGui::GetColorU32(ImGuiCol_WindowBg));
  ImGui::GetWindowDrawList()->AddRectFilled({from.x, end_of_own - line}, {to.x, end_of_own},
                                            ImGui::GetColorU32(ImGuiCol_Separator));
  const float top = ImGui::GetCursorPosY();
  draw_framed(context, own, HeaderClick::folds);
  const float height = ImGui::GetCursorPosY() - top;
  if (below) draw_panel_header(context, *below);
  ImGui::EndChild();
  ImGui::SetCursorPosY(end);
  if (std::exchange(height_px, height) != height) context.state.unsettle();
}

// Scrolls the column so that a panel which was drawn from here on is seen whole, or from its header on where it is
// higher than the column; until it lies in a frame where it lay in the one before.
void SideColumns::show_wanted(PanelContext& context, float begin, float height, float kept_px) {
  const float end = ImGui::GetCursorPosY(), scroll = ImGui::GetScrollY();
  ImGui::SetScrollY(std::min(begin - kept_px, std::max(scroll, end - height)));
  const bool is_settled = begin == std::exchange(wanted_begin_, begin) && end == std::exchange(wanted_end_, end);
  if (!is_settled) return context.state.unsettle();
  context.layout.wanted.clear();
  wanted_begin_ = wanted_end_ = -1;
}

// The first one stays in view where the column is scrolled, if it is one that is held and leaves room enough. Returns
// how much it covers.
float SideColumns::draw_panels(PanelContext& context, PanelPlace side, float height, std::vector<OwnPanel>& panels) {
  float& held_px = held_px_[side == PanelPlace::left ? 0 : 1];
  const float first = ImGui::GetCursorPosY();
  OwnPanel* over = nullptr;
  float kept_px = 0;
  std::vector<Lying> lying;
  for (OwnPanel& own : panels) {
    if (!lies_in(context, own.row, side)) continue;
    const float begin = ImGui::GetCursorPosY();
    const bool is_held = own.row.at_first == PanelAtFirst::held && begin == first && 2 * held_px < height;
    if (is_held && held_px > 0 && ImGui::GetScrollY() > 0) {
      over = &own;
      ImGui::SetCursorPosY(begin + held_px);
    } else {
      draw_framed(context, own, HeaderClick::folds);
      if (own.row.at_first == PanelAtFirst::held) held_px = ImGui::GetCursorPosY() - begin;
    }
    if (is_held) kept_px = first + held_px;
    if (context.layout.wanted == own.row.id) show_wanted(context, begin, height, kept_px);
    lying.push_back({&own, begin, ImGui::GetCursorPosY()});
  }
  if (!over) return 0;
  const float header = ImGui::GetFrameHeightWithSpacing(), edge = ImGui::GetScrollY() + first + held_px;
  const auto below = std::find_if(lying.begin() + 1, lying.end(),
                                  [&](const Lying& l) { return l.begin < edge && edge + header < l.end; });
  draw_over(context, *over, first, held_px, below == lying.end() ? nullptr : &below->own->row);
  return first + held_px + (below == lying.end() ? 0 : header);
}

void SideColumns::draw_column(PanelContext& context, PanelPlace side, const Areas& areas,
                              std::vector<OwnPanel>& panels) {
  const PixelRect& area = areas.column(side);
  if (area.empty()) return;
  if (areas.has_tabs) return draw_tabs(context, side, area);
  const bool is_left = side == PanelPlace::left;
  const float border = std::round(border_px * context.scale), x = static_cast<float>(area.x0);
  ImGui::SetNextWindowPos({is_left ? x : x + border, static_cast<float>(area.y0)});
  ImGui::SetNextWindowSize({static_cast<float>(area.width()) - border, static_cast<float>(area.height())});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {8 * context.scale, 4 * context.scale});
  const ColumnNames& own_names = names[is_left ? 0 : 1];
  ImGui::Begin(own_names.column, nullptr, column_flags);
  ImGui::PopStyleVar(2);
  bool& is_tight = is_tight_[is_left ? 0 : 1];
  context.state.is_tight = is_tight;
  context.state.saved_px = 0;
  const float covered_px = draw_panels(context, side, static_cast<float>(area.height()), panels);
  if (ImGui::GetScrollMaxY() > 0) scrolled_.push_back(seen_part(own_names, covered_px));
  // By what the whole would need, so that it does not come and go. What leaves no room for a scroll bar is wrapped anew
  // where there is one, and may need some lines fewer without it.
  const float whole = ImGui::GetCursorPosY() + context.state.saved_px, height = static_cast<float>(area.height());
  const bool needs_more = is_tight ? whole + 3 * ImGui::GetTextLineHeightWithSpacing() > height
                                   : whole > height || ImGui::GetScrollMaxY() > 0;
  if (std::exchange(is_tight, needs_more) != context.state.is_tight) context.state.unsettle();
  context.state.is_tight = false;
  ImGui::End();
  draw_border(context, side, area);
}

void SideColumns::draw_flyout(PanelContext& context, const Areas& areas, std::vector<OwnPanel>& panels) {
  flyout_size_ = {0, 0};
  const std::string open = areas.has_tabs ? context.layout.flyout : "";
  const auto own = std::find_if(panels.begin(), panels.end(), [&](const OwnPanel& p) { return p.row.id == open; });
  if (own == panels.end()) {
    context.layout.flyout.clear();
    return;
  }
  const PanelPlace side = context.layout.side_of(own->row);
  const PixelRect& view = areas.view;
  const float wide = static_cast<float>(context.layout.width_px(side)) * context.column_scale;
  const float width = std::min(std::round(wide), static_cast<float>(view.width()));
  const bool is_left = side == PanelPlace::left;
  ImGui::SetNextWindowPos({static_cast<float>(is_left ? view.x0 : view.x1), static_cast<float>(view.y0)}, 0,
                          {is_left ? 0.f : 1.f, 0});
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, static_cast<float>(view.height())});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {8 * context.scale, 4 * context.scale});
  ImGui::Begin("##flyout", nullptr,
               (column_flags & ~ImGuiWindowFlags_NoBringToFrontOnFocus) | ImGuiWindowFlags_AlwaysAutoResize);
  ImGui::PopStyleVar(3);
  draw_framed(context, *own, HeaderClick::closes);
  flyout_at_ = ImGui::GetWindowPos();
  flyout_size_ = ImGui::GetWindowSize();
  if (ImGui::GetScrollMaxY() > 0) scrolled_.push_back(seen_part({"##flyout", ""}, 0));
  ImGui::End();
}

void SideColumns::draw(PanelContext& context, const Areas& areas, std::vector<OwnPanel>& panels) {
  // Behind a tab a panel is shown by being opened.
  if (std::string& wanted = context.layout.wanted; areas.has_tabs && !wanted.empty())
    context.layout.flyout = std::exchange(wanted, {});
  scrolled_.clear();
  draw_column(context, PanelPlace::left, areas, panels);
  draw_column(context, PanelPlace::right, areas, panels);
  draw_flyout(context, areas, panels);
}

glm::dvec2 SideColumns::covered_px(const PixelRect& view) const {
  if (flyout_size_.x <= 0) return {0, 0};
  const bool is_left = flyout_at_.x <= static_cast<float>(view.x0);
  return is_left ? glm::dvec2(flyout_size_.x, 0) : glm::dvec2(0, flyout_size_.x);
}

bool SideColumns::covers(glm::dvec2 pixel) const {
  return pixel.x >= flyout_at_.x && pixel.x < flyout_at_.x + flyout_size_.x && pixel.y >= flyout_at_.y &&
         pixel.y < flyout_at_.y + flyout_size_.y;
}

}  // namespace ryosen
