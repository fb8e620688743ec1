#include "app/ui/widgets.h"

#include <imgui_internal.h>  // that the keyboard chooses in a window, and who has it

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <utility>

#include "app/editor/preferences/keys.h"
#include "app/editor/preferences/layout.h"
#include "app/editor/preferences/preference_values.h"
#include "app/editor/session/selecting.h"
#include "app/editor/shown/shown.h"
#include "ryosen/base/rows.h"
#include "ryosen/mesh/mesh.h"
// clang-format off
#include <imgui_stdlib.h>  // needs imgui.h before it
// clang-format on

namespace ryosen {

void coloured_text(const ImVec4& colour, const char* text) {
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  wrapped_text(text);
  ImGui::PopStyleColor();
}

void dim_text(PanelContext& context, const char* text) { coloured_text(context.colours().dim, text); }

void bold_text(PanelContext& context, const char* text) {
  ImGui::PushFont(context.fonts.bold);
  ImGui::TextUnformatted(text);
  ImGui::PopFont();
}

void labelled(PanelContext& context, const char* label, const std::string& value, float column) {
  ImGui::TextColored(context.colours().dim, "%s", label);
  const float least = ImGui::GetStyle().WindowPadding.x + ImGui::CalcTextSize(label).x + 0.8f * ImGui::GetFontSize();
  const float at = std::max(column * ImGui::GetFontSize(), least), em = ImGui::GetFontSize();
  const float room = ImGui::GetWindowContentRegionMax().x - at;
  if (room > ImGui::CalcTextSize(value.c_str()).x || room > 5 * em) ImGui::SameLine(at);
  wrapped_text(value.c_str());
}

bool link(PanelContext& context, const char* text) {
  const ImVec2 at = ImGui::GetCursorScreenPos(), size = ImGui::CalcTextSize(text);
  const bool clicked = ImGui::InvisibleButton(text, size);
  const bool hovered = ImGui::IsItemHovered();
  ImGui::RenderNavHighlight({at, {at.x + size.x, at.y + size.y}}, ImGui::GetItemID());
  const ImU32 colour = ImGui::GetColorU32(context.colours().accent);
  ImGui::GetWindowDrawList()->AddText(at, colour, text);
  if (hovered) {
    ImGui::GetWindowDrawList()->AddLine({at.x, at.y + size.y}, {at.x + size.x, at.y + size.y}, colour);
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  }
  return clicked;
}

std::string link_name(const Mesh& mesh, const Element& element) {
  return element.kind == Element::Kind::halfedge ? name_and_slot(mesh, element) : name_of(mesh, element);
}

bool element_links(PanelContext& context, const std::vector<Element>& elements) {
  constexpr std::size_t most = 24;
  const float right_edge = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  const float gap = ImGui::GetFontSize() * 0.6f;
  std::string chosen;
  for (std::size_t i = 0; i < std::min(elements.size(), most); ++i) {
    const std::string name = link_name(context.mesh(), elements[i]);
    ImGui::PushID(static_cast<int>(i));
    if (i > 0 && ImGui::GetItemRectMax().x + gap + ImGui::CalcTextSize(name.c_str()).x < right_edge)
      ImGui::SameLine(0, gap);
    if (link(context, name.c_str())) chosen = name_to_select(context.mesh(), elements[i]);
    tip(context.text("A click selects it.", "クリックすると選択します。"));
    ImGui::PopID();
  }
  if (elements.size() > most) {
    ImGui::SameLine(0, gap);
    ImGui::TextDisabled("+%zu", elements.size() - most);
  }
  if (chosen.empty()) return false;
  context.run("select " + chosen);
  return true;
}

bool marked_row(PanelContext& context, bool is_active, float height_px, ImGuiSelectableFlags flags) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushStyleColor(ImGuiCol_Header, ImGui::GetStyleColorVec4(ImGuiCol_FrameBgActive));
  const bool clicked = ImGui::Selectable("##row", is_active, flags, {ImGui::GetContentRegionAvail().x, height_px});
  ImGui::PopStyleColor();
  if (is_active)
    ImGui::GetWindowDrawList()->AddRectFilled({at.x, at.y}, {at.x + 3 * context.scale, at.y + height_px},
                                              ImGui::GetColorU32(context.colours().accent), 2);
  return clicked;
}

namespace {

// Before its label, behind what is right, and at least between the two.
struct RowGaps {
  explicit RowGaps(float scale) : before(10 * scale), behind(8 * scale), between(6 * scale) {}
  float before, behind, between;
};

}  // namespace

float row_width(const PanelContext& context, const std::string& label, const std::string& right) {
  const RowGaps gaps(context.scale);
  const float beside = right.empty() ? 0 : gaps.between + ImGui::CalcTextSize(right.c_str()).x;
  return gaps.before + ImGui::CalcTextSize(label.c_str()).x + beside + gaps.behind;
}

bool row(PanelContext& context, const char* label, const char* right, bool is_active, float free_px, float below_px) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = row_pitch(context) - ImGui::GetStyle().ItemSpacing.y;
  const bool clicked = marked_row(context, is_active, height + below_px);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float line = at.y + std::floor((height - ImGui::GetFontSize()) / 2);
  const RowGaps gaps(context.scale);
  const float begin = at.x + gaps.before;
  float end = at.x + width - gaps.behind - free_px;
  if (right && *right) {
    // What is on the right may take what the label leaves, and always two fifths.
    const float room = end - begin, left = room - ImGui::CalcTextSize(label).x - gaps.between;
    const std::string shown = fitted(right, std::max(left, 0.4f * room));
    end -= ImGui::CalcTextSize(shown.c_str()).x;
    list.AddText({end, line}, ImGui::GetColorU32(context.colours().dim), shown.c_str());
    end -= gaps.between;
  }
  list.AddText({begin, line}, ImGui::GetColorU32(ImGuiCol_Text), fitted_at_word(label, end - begin).c_str());
  return clicked;
}

float row_pitch(const PanelContext& context) { return ImGui::GetTextLineHeightWithSpacing() + 2 * context.scale; }

void begin_rows(const char* id, float rows, float width_px, float pitch) {
  if (pitch == 0) pitch = ImGui::GetTextLineHeightWithSpacing();
  ImGui::BeginChild(id, {width_px, rows * pitch}, false, ImGuiWindowFlags_NavFlattened);
}

void begin_rows_within(const char* id, float height_px, float width_px) {
  begin_rows(id, std::max(std::floor(height_px / ImGui::GetTextLineHeightWithSpacing()), 1.f), width_px);
}

void end_rows(float pitch) {
  if (pitch == 0) pitch = ImGui::GetTextLineHeightWithSpacing();
  const float now = ImGui::GetScrollY();
  float& before = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID("scroll"));
  // On to the next whole row in the direction of the wheel.
  const float whole = (now > before ? std::ceil(now / pitch - 0.01f) : std::floor(now / pitch + 0.01f)) * pitch;
  before = std::min(whole, ImGui::GetScrollMaxY());
  if (std::abs(before - now) >= 0.5f) ImGui::SetScrollY(before);
  ImGui::EndChild();
}

void list_of_rows(const char* id, std::size_t count, std::size_t most, const std::function<void(std::size_t)>& draw,
                  std::optional<float> scrolls_to, float pitch) {
  if (count == 0) return;  // a child of no height would take all there is
  if (pitch == 0) pitch = ImGui::GetTextLineHeightWithSpacing();
  begin_rows(id, static_cast<float>(std::min(count, most)), 0, pitch);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(count), pitch);
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      ImGui::PushID(i);
      draw(static_cast<std::size_t>(i));
      ImGui::PopID();
    }
  }
  ImGui::Dummy({0, 0});  // to the whole pitch of the last row, so that it can be scrolled to
  if (scrolls_to) ImGui::SetScrollY(*scrolls_to);
  end_rows(pitch);
}

std::string fitted(std::string_view text, float width_px) {
  const auto width = [](const std::string& t) { return ImGui::CalcTextSize(t.c_str(), t.c_str() + t.size()).x; };
  std::string all(text);
  if (width(all) <= width_px) return all;
  std::vector<std::size_t> cuts;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (begins_letter(text[i])) cuts.push_back(i);
  const auto cut = [&](std::size_t at) { return all.substr(0, at) + "\u2026"; };
  const auto fits = [&](std::size_t at) { return width(cut(at)) <= width_px; };
  const auto first_too_long = std::partition_point(cuts.begin(), cuts.end(), fits);
  return cut(first_too_long == cuts.begin() ? 0 : *std::prev(first_too_long));
}

// Back to the end of the last word, unless that would leave out much of what fits.
std::string fitted_at_word(std::string_view text, float width_px) {
  std::string shown = fitted(text, width_px);
  if (shown == text) return shown;
  const std::string_view ellipsis = "\u2026";
  const std::size_t cut = shown.size() - ellipsis.size(), blank = text.rfind(' ', cut);
  const std::size_t end = blank == text.npos ? text.npos : text.find_last_not_of(" ,;:", blank);
  if (end == text.npos || 2 * end < cut) return shown;
  return std::string(text.substr(0, end + 1)) + std::string(ellipsis);
}

void fitted_text(const std::string& text, float width_px) {
  const std::string shown = fitted_at_word(text, width_px);
  ImGui::TextUnformatted(shown.c_str());
  if (shown != text) tip(text);
}

bool begin_over(PanelContext& context, const PanelRow& row, ImVec2 size, bool leaves_view) {
  const bool wanted = context.layout.open_panel == row.id;
  const std::string name = context.title(row) + ("###" + std::string(row.id));
  if (!wanted && !ImGui::IsPopupOpen(name.c_str())) return false;
  if (!ImGui::IsPopupOpen(name.c_str())) ImGui::OpenPopup(name.c_str());
  const ImVec2 all = ImGui::GetIO().DisplaySize;
  const float scale = context.column_scale;
  ImVec2 scaled{std::min(size.x * scale, all.x - 20), std::min(size.y * scale, all.y - 20)};
  if (leaves_view) scaled.x = std::min(scaled.x, std::max(0.46f * all.x, 290 * scale));
  const float left = leaves_view ? all.x - scaled.x - 10 : std::floor((all.x - scaled.x) / 2);
  // One that leaves the view to be seen begins below the menus, however high it is: its fields are where they were.
  const float menus = ImGui::GetFrameHeight() + 10, middle = std::floor((all.y - scaled.y) / 2);
  ImGui::SetNextWindowPos({left, leaves_view ? std::min(menus, 2 * middle - 10) : middle});
  ImGui::SetNextWindowSize(scaled);
  // What lies behind it is not dimmed: a border tells where it ends.
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize,
                      leaves_view ? std::max(std::round(1.5f * context.scale), 1.f) : 0);
  ImGui::PushStyleColor(ImGuiCol_Border, context.colours().dim);
  bool stays_open = true;
  const bool is_shown = ImGui::BeginPopupModal(name.c_str(), &stays_open,
                                               ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  // Its first field or button can be pressed at once.
  if (is_shown && ImGui::IsWindowAppearing()) GImGui->NavDisableHighlight = false;
  if (is_shown && wanted) {
    ImGui::PushItemFlag(ImGuiItemFlags_Inputable, true);  // all that can be pressed or written into: Tab stops there
    return true;
  }
  if (is_shown) {
    ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
  } else if (wanted) {
    context.run("panel none");
  }
  return false;
}

void end_over() {
  ImGui::PopItemFlag();
  ImGui::EndPopup();
}

void give_keyboard_to_next() {
  ImGui::SetKeyboardFocusHere();
  GImGui->NavDisableHighlight = false;
}

bool is_left_alone(const char* field) {
  return !ImGui::IsAnyItemActive() && (GImGui->NavDisableHighlight || GImGui->NavId == ImGui::GetID(field));
}

std::string chord_of(std::span<const KeyRow> keys, std::string_view command) {
  for (const KeyRow& key : keys)
    if (key.command == command) return key.chord;
  return {};
}

std::string chord_of(const Preferences& preferences, std::string_view command) {
  return chord_of(key_table(input_presets()[preferences.input_preset], preferences.bindings), command);
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

namespace {

// Enter, taken from the item with this id, which has the keyboard, before it is drawn.
bool takes_enter(const std::string& id) {
  ImGuiContext& imgui = *GImGui;
  if (imgui.NavActivateId != ImGui::GetID(id.c_str()) || !ImGui::IsKeyPressed(ImGuiKey_Enter, false)) return false;
  imgui.NavActivateId = imgui.NavActivateDownId = imgui.NavActivatePressedId = 0;
  return true;
}

}  // namespace

bool draw_parameter_field(PanelContext& context, const ParameterRow& row, std::string& text, EnterAt enter) {
  const std::string id = "##" + std::string(row.id);
  const char* const of_selection = context.text("Selection", "選択中の要素");
  const bool takes_elements = row.kind == ParameterKind::elements;
  const float button = ImGui::CalcTextSize(of_selection).x + 2 * ImGui::GetStyle().FramePadding.x;
  ImGui::SetNextItemWidth(takes_elements ? -button - ImGui::GetStyle().ItemSpacing.x : -1);
  const bool is_pressed = row.kind == ParameterKind::flag || row.kind == ParameterKind::choice;
  const bool runs = is_pressed && enter == EnterAt::runs && takes_enter(id);
  if (row.kind == ParameterKind::flag) {
    bool is_on = text == "on";
    if (ImGui::Checkbox(id.c_str(), &is_on)) text = is_on ? "on" : "off";
    return runs;
  }
  const Choice* const chosen = find_row(row.choices, text);
  if (row.kind == ParameterKind::choice) {
    const char* const shown = chosen ? context.text(chosen->en, chosen->ja) : "";
    if (!ImGui::BeginCombo(id.c_str(), shown)) return runs;
    for (const Choice& choice : row.choices)
      if (ImGui::Selectable(context.text(choice.en, choice.ja), choice.id == text)) text = choice.id;
    ImGui::EndCombo();
    return false;
  }
  const bool entered =
      ImGui::InputText(id.c_str(), &text, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  if (!takes_elements) return entered;
  ImGui::SameLine();
  if (ImGui::Button((of_selection + ("##selection_" + id)).c_str())) {
    context.shown.end();  // what is shown before it is run has no selection
    text = context.selecting.selection.empty() ? "" : selection_word;
  }
  return entered;
}

}  // namespace ryosen
