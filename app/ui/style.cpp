#include "app/ui/style.h"

namespace ryosen {

namespace {

struct Ground {
  Rgba window, panel, field, field_hovered, field_active, header, header_hovered, line, text, dim, accent, legal,
      refused, warning, backdrop;
};

constexpr Ground dark_ground = {
    .window = rgb(0x171C23),
    .panel = rgb(0x1E242D),
    .field = rgb(0x29313C),
    .field_hovered = rgb(0x333D4A),
    .field_active = rgb(0x3D4958),
    .header = rgb(0x262E39),
    .header_hovered = rgb(0x303A47),
    .line = rgb(0x323C49),
    .text = rgb(0xDDE3EA),
    .dim = rgb(0x8F9BAA),
    .accent = rgb(0x56B4E9),
    .legal = rgb(0x2CC79A),
    .refused = rgb(0xF0803C),
    .warning = rgb(0xE6B450),
    .backdrop = rgb(0x0B0E12, 150),
};

constexpr Ground light_ground = {
    .window = rgb(0xE4E8ED),
    .panel = rgb(0xF4F6F8),
    .field = rgb(0xE3E8EE),
    .field_hovered = rgb(0xD6DDE6),
    .field_active = rgb(0xC8D2DE),
    .header = rgb(0xE6EBF1),
    .header_hovered = rgb(0xDAE1EA),
    .line = rgb(0xCBD3DD),
    .text = rgb(0x1D2530),
    .dim = rgb(0x5E6B7B),
    .accent = rgb(0x0072B2),
    .legal = rgb(0x007A59),
    .refused = rgb(0xB84E00),
    .warning = rgb(0x8A6100),
    .backdrop = rgb(0x3A4656, 110),
};

const Ground& ground(Theme theme) { return theme == Theme::dark ? dark_ground : light_ground; }

UiColours made_from(const Ground& g) {
  return {to_imgui(g.dim),     to_imgui(g.accent),   to_imgui(g.legal), to_imgui(g.refused),
          to_imgui(g.warning), to_imgui(g.backdrop), to_imgui(g.panel), to_imgui(g.line)};
}

void apply_colours(const Ground& g) {
  ImVec4* c = ImGui::GetStyle().Colors;
  const ImVec4 accent = to_imgui(g.accent), none(0, 0, 0, 0);
  c[ImGuiCol_Text] = to_imgui(g.text);
  c[ImGuiCol_TextDisabled] = to_imgui(g.dim);
  c[ImGuiCol_WindowBg] = c[ImGuiCol_PopupBg] = to_imgui(g.panel);
  c[ImGuiCol_MenuBarBg] = to_imgui(g.window);
  c[ImGuiCol_ChildBg] = none;
  c[ImGuiCol_Border] = c[ImGuiCol_Separator] = to_imgui(g.line);
  c[ImGuiCol_FrameBg] = c[ImGuiCol_Button] = to_imgui(g.field);
  c[ImGuiCol_FrameBgHovered] = c[ImGuiCol_ButtonHovered] = to_imgui(g.field_hovered);
  c[ImGuiCol_FrameBgActive] = c[ImGuiCol_ButtonActive] = to_imgui(g.field_active);
  c[ImGuiCol_Header] = to_imgui(g.header);
  c[ImGuiCol_HeaderHovered] = to_imgui(g.header_hovered);
  c[ImGuiCol_HeaderActive] = to_imgui(g.field_active);
  c[ImGuiCol_CheckMark] = c[ImGuiCol_NavHighlight] = accent;
  c[ImGuiCol_TextSelectedBg] = ImVec4(accent.x, accent.y, accent.z, 0.35f);
  c[ImGuiCol_ScrollbarBg] = none;
  c[ImGuiCol_ScrollbarGrab] = to_imgui(g.field_hovered);
  c[ImGuiCol_ScrollbarGrabHovered] = c[ImGuiCol_ScrollbarGrabActive] = to_imgui(g.field_active);
  c[ImGuiCol_TableRowBg] = c[ImGuiCol_TableRowBgAlt] = none;
  c[ImGuiCol_TitleBg] = c[ImGuiCol_TitleBgActive] = to_imgui(g.header);
  c[ImGuiCol_ModalWindowDimBg] = to_imgui(g.backdrop);
}

}  // namespace

const UiColours& ui_colours(Theme theme) {
  static const UiColours dark = made_from(dark_ground), light = made_from(light_ground);
  return theme == Theme::dark ? dark : light;
}

void apply_style(Theme theme, float scale) {
  ImGuiStyle style;
  style.WindowPadding = {12, 8};
  style.FramePadding = {6, 4};
  style.ItemSpacing = {8, 4};
  style.ItemInnerSpacing = {8, 4};
  style.CellPadding = {4, 2};
  style.IndentSpacing = 14;
  style.ScrollbarSize = 11;
  style.WindowRounding = style.PopupRounding = 6;
  style.FrameRounding = style.ChildRounding = style.GrabRounding = 4;
  style.ScrollbarRounding = 6;
  style.WindowBorderSize = 0;
  style.PopupBorderSize = 1;
  style.WindowTitleAlign = {0.02f, 0.5f};
  style.DisabledAlpha = 0.45f;
  style.ScaleAllSizes(scale);
  ImGui::GetStyle() = style;
  apply_colours(ground(theme));
}

}  // namespace ryosen
