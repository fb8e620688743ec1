#include "app/ui/side_columns.h"
#include "app/editor/preferences/layout.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ryosen {

namespace {

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

// Of the window that is drawn.
SeenPart seen_part(const ColumnNames& of, float covered_px) {
  const float top = ImGui::GetWindowPos().y, border = ImGui::GetStyle().WindowBorderSize;
  return {of.column, of.covering, top + covered_px, top + ImGui::GetWindowSize().y - border};
}

bool lies_in(const PanelContext& context, const PanelRow& row, PanelPlace side) {
  return row.place != PanelPlace::over && context.layout.side_of(row) == side && context.layout.is_shown(row);
}

}  // namespace

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
