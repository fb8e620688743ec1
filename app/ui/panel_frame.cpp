#include "app/ui/panel_frame.h"

#include "app/editor/document/findings.h"
#include "app/editor/preferences/layout.h"
#include "app/ui/widgets.h"

namespace ryosen {

namespace {

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

// True while the panel is unfolded.
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

}  // namespace

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

}  // namespace ryosen
