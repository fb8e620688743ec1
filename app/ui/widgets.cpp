#include "app/ui/widgets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "app/editor/keys.h"
#include "core/base/enum_table.h"

namespace ryosen {

void coloured_text(const ImVec4& colour, const char* text) {
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text);
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

void dim_text(PanelContext& context, const char* text) { coloured_text(context.colours().dim, text); }

void labelled(PanelContext& context, const char* label, const std::string& value, float column) {
  ImGui::TextColored(context.colours().dim, "%s", label);
  const float least = ImGui::GetStyle().WindowPadding.x + ImGui::CalcTextSize(label).x + 0.8f * ImGui::GetFontSize();
  ImGui::SameLine(std::max(column * ImGui::GetFontSize(), least));
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(value.c_str());
  ImGui::PopTextWrapPos();
}

bool link(PanelContext& context, const char* text) {
  const ImVec2 at = ImGui::GetCursorScreenPos(), size = ImGui::CalcTextSize(text);
  const bool clicked = ImGui::InvisibleButton(text, size);
  const bool hovered = ImGui::IsItemHovered();
  const ImU32 colour = ImGui::GetColorU32(context.colours().accent);
  ImGui::GetWindowDrawList()->AddText(at, colour, text);
  if (hovered) {
    ImGui::GetWindowDrawList()->AddLine({at.x, at.y + size.y}, {at.x + size.x, at.y + size.y}, colour);
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  }
  return clicked;
}

void element_links(PanelContext& context, const std::vector<Element>& elements) {
  constexpr std::size_t most = 24;
  const float right_edge = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  const float gap = ImGui::GetFontSize() * 0.6f;
  std::string chosen;
  for (std::size_t i = 0; i < std::min(elements.size(), most); ++i) {
    const std::string name = name_of(context.session.mesh(), elements[i]);
    ImGui::PushID(static_cast<int>(i));
    if (i > 0 && ImGui::GetItemRectMax().x + gap + ImGui::CalcTextSize(name.c_str()).x < right_edge)
      ImGui::SameLine(0, gap);
    if (link(context, name.c_str())) chosen = name_to_select(context.session.mesh(), elements[i]);
    ImGui::PopID();
  }
  if (elements.size() > most) {
    ImGui::SameLine(0, gap);
    ImGui::TextDisabled("+%zu", elements.size() - most);
  }
  if (!chosen.empty()) context.run("select " + chosen);
}

bool row(PanelContext& context, const char* label, const char* right, bool is_active) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = ImGui::GetFrameHeight();
  ImGui::PushStyleColor(ImGuiCol_Header, ImGui::GetStyleColorVec4(ImGuiCol_FrameBgActive));
  const bool clicked = ImGui::Selectable("##row", is_active, 0, {width, height - ImGui::GetStyle().ItemSpacing.y});
  ImGui::PopStyleColor();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float baseline = at.y + (height - ImGui::GetStyle().ItemSpacing.y - ImGui::GetFontSize()) / 2;
  if (is_active)
    list.AddRectFilled({at.x, at.y + 2},
                       {at.x + 3 * context.scale, at.y + height - ImGui::GetStyle().ItemSpacing.y - 2},
                       ImGui::GetColorU32(context.colours().accent), 2);
  list.AddText({at.x + 10 * context.scale, baseline}, ImGui::GetColorU32(ImGuiCol_Text), label);
  if (right && *right) {
    const float end = at.x + width - ImGui::CalcTextSize(right).x - 8 * context.scale;
    list.AddText({end, baseline}, ImGui::GetColorU32(context.colours().dim), right);
  }
  return clicked;
}

namespace {

// The lengths of dashes and gaps of a line style, in widths of the line; a zero ends the list.
struct DashRow {
  LineStyle style;
  std::array<float, 4> lengths;
};
constexpr DashRow dashes[] = {
    {LineStyle::solid, {}},
    {LineStyle::dashed, {3, 2, 0, 0}},
    {LineStyle::dash_dot, {3, 1.5f, 1, 1.5f}},
    {LineStyle::dotted, {1, 1.5f, 0, 0}},
};
static_assert(rows_are_in_order(dashes, &DashRow::style));

}  // namespace

void swatch(const Style& style, float width_px) {
  const float height = ImGui::GetFontSize();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::Dummy({width_px, height});
  const ImU32 colour = to_imgui32(style.colour);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float middle = std::floor(at.y + height / 2), half = 1.5f;
  const std::array<float, 4>& pattern = dashes[static_cast<std::size_t>(style.line)].lengths;
  if (pattern[0] == 0) return list.AddRectFilled({at.x, middle - half}, {at.x + width_px, middle + half}, colour);
  float x = at.x;
  for (std::size_t i = 0; x < at.x + width_px; i = (i + 1) % 4) {
    const float length = pattern[i] * 3;
    if (i % 2 == 0 && length > 0)
      list.AddRectFilled({x, middle - half}, {std::min(x + length, at.x + width_px), middle + half}, colour);
    x += length;
  }
}

bool begin_over(PanelContext& context, const PanelRow& row, ImVec2 size) {
  const bool wanted = context.session.open_panel == row.id;
  const std::string name = context.title(row) + ("###" + std::string(row.id));
  if (!wanted && !ImGui::IsPopupOpen(name.c_str())) return false;
  if (!ImGui::IsPopupOpen(name.c_str())) ImGui::OpenPopup(name.c_str());
  const ImVec2 all = ImGui::GetIO().DisplaySize;
  const ImVec2 scaled{std::min(size.x * context.scale, all.x - 20), std::min(size.y * context.scale, all.y - 20)};
  ImGui::SetNextWindowPos({std::floor((all.x - scaled.x) / 2), std::floor((all.y - scaled.y) / 2)});
  ImGui::SetNextWindowSize(scaled);
  bool stays_open = true;
  const bool is_shown = ImGui::BeginPopupModal(name.c_str(), &stays_open,
                                               ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings);
  if (is_shown && wanted) return true;
  if (is_shown) {
    ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
  } else if (wanted) {
    context.run("panel none");
  }
  return false;
}

void end_over() { ImGui::EndPopup(); }

std::string chord_of(const Session& session, std::string_view command) {
  for (const KeyRow& key : key_table(input_presets()[session.input_preset]))
    if (key.command == command) return key.chord;
  return {};
}

std::string grouped(std::int64_t n) {
  std::string digits = std::to_string(n < 0 ? -n : n);
  for (std::size_t i = digits.size(); i > 3;) digits.insert(i -= 3, ",");
  return n < 0 ? "\u2212" + digits : digits;
}

std::string short_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text[0] == '-' ? "\u2212" + std::string(text + 1) : std::string(text);
}

void tip(std::string_view text, ImGuiHoveredFlags hovered) {
  if (!ImGui::IsItemHovered(hovered)) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(22 * ImGui::GetFontSize());
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

}  // namespace ryosen
