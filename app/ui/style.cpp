#include "app/ui/style.h"

namespace ryosen {

namespace {

// A colour in the dark and in the light theme.
struct Tone {
  Rgba dark, light;
  ImVec4 in(Theme theme) const { return to_imgui(theme == Theme::dark ? dark : light); }
};

constexpr struct Ground {
  Tone window{rgb(0x171C23), rgb(0xE4E8ED)};
  Tone panel{rgb(0x1E242D), rgb(0xF4F6F8)};
  Tone field{rgb(0x29313C), rgb(0xE3E8EE)};
  Tone field_hovered{rgb(0x333D4A), rgb(0xD6DDE6)};
  Tone field_active{rgb(0x3D4958), rgb(0xC8D2DE)};
  Tone header{rgb(0x262E39), rgb(0xE6EBF1)};
  Tone header_hovered{rgb(0x303A47), rgb(0xDAE1EA)};
  Tone line{rgb(0x323C49), rgb(0xCBD3DD)};
  Tone thumb{rgb(0x6F7D8E), rgb(0x7F8C9B)};
  Tone text{rgb(0xDDE3EA), rgb(0x1D2530)};
  Tone dim{rgb(0x8F9BAA), rgb(0x5E6B7B)};
  Tone accent{rgb(0x56B4E9), rgb(0x0072B2)};
  Tone legal{rgb(0x2CC79A), rgb(0x007A59)};
  Tone refused{rgb(0xF0803C), rgb(0xB84E00)};
  Tone warning{rgb(0xE6B450), rgb(0x8A6100)};
  Tone backdrop{rgb(0x0B0E12, 150), rgb(0x3A4656, 110)};
} ground;

UiColours made_for(Theme theme) {
  return {ground.dim.in(theme),     ground.accent.in(theme),   ground.legal.in(theme), ground.refused.in(theme),
          ground.warning.in(theme), ground.backdrop.in(theme), ground.panel.in(theme), ground.line.in(theme)};
}

void apply_colours(Theme theme) {
  ImVec4* c = ImGui::GetStyle().Colors;
  const ImVec4 accent = ground.accent.in(theme), none(0, 0, 0, 0);
  c[ImGuiCol_Text] = ground.text.in(theme);
  c[ImGuiCol_TextDisabled] = ground.dim.in(theme);
  c[ImGuiCol_WindowBg] = c[ImGuiCol_PopupBg] = ground.panel.in(theme);
  c[ImGuiCol_MenuBarBg] = ground.window.in(theme);
  c[ImGuiCol_ChildBg] = none;
  c[ImGuiCol_Border] = c[ImGuiCol_Separator] = ground.line.in(theme);
  c[ImGuiCol_FrameBg] = c[ImGuiCol_Button] = ground.field.in(theme);
  c[ImGuiCol_FrameBgHovered] = c[ImGuiCol_ButtonHovered] = ground.field_hovered.in(theme);
  c[ImGuiCol_FrameBgActive] = c[ImGuiCol_ButtonActive] = ground.field_active.in(theme);
  c[ImGuiCol_Header] = ground.header.in(theme);
  c[ImGuiCol_HeaderHovered] = ground.header_hovered.in(theme);
  c[ImGuiCol_HeaderActive] = ground.field_active.in(theme);
  c[ImGuiCol_CheckMark] = c[ImGuiCol_NavHighlight] = accent;
  c[ImGuiCol_TextSelectedBg] = ImVec4(accent.x, accent.y, accent.z, 0.35f);
  c[ImGuiCol_ScrollbarBg] = none;
  c[ImGuiCol_ScrollbarGrab] = ground.thumb.in(theme);
  c[ImGuiCol_ScrollbarGrabHovered] = ground.dim.in(theme);
  c[ImGuiCol_ScrollbarGrabActive] = accent;
  c[ImGuiCol_TableRowBg] = c[ImGuiCol_TableRowBgAlt] = none;
  c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = ground.header.in(theme);
  c[ImGuiCol_ModalWindowDimBg] = ground.backdrop.in(theme);
}

}  // namespace

const UiColours& ui_colours(Theme theme) {
  static const UiColours dark = made_for(Theme::dark), light = made_for(Theme::light);
  return theme == Theme::dark ? dark : light;
}

void apply_style(Theme theme, float scale) {
  ImGuiStyle style;
  style.WindowPadding = {12, 8};
  style.FramePadding = {6, frame_padding_px};
  style.ItemSpacing = {8, 4};
  style.ItemInnerSpacing = {8, 4};
  style.CellPadding = {4, 2};
  style.IndentSpacing = 14;
  style.ScrollbarSize = 16;  // ImGui leaves three pixels on each side of the thumb
  style.GrabMinSize = 24;
  style.WindowRounding = style.PopupRounding = 6;
  style.FrameRounding = style.ChildRounding = style.GrabRounding = 4;
  style.ScrollbarRounding = 6;
  style.WindowBorderSize = 0;
  style.PopupBorderSize = 1;
  style.WindowTitleAlign = {0.02f, 0.5f};
  style.DisabledAlpha = 0.45f;
  style.ScaleAllSizes(scale);
  ImGui::GetStyle() = style;
  apply_colours(theme);
}

}  // namespace ryosen
