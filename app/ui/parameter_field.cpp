#include "app/ui/parameter_field.h"

#include <imgui_internal.h>  // who has the keyboard

#include <algorithm>

#include "app/editor/session/selecting.h"
#include "app/editor/shown/shown.h"
#include "app/ui/widgets.h"
// clang-format off
#include <imgui_stdlib.h>  // needs imgui.h before it
// clang-format on

namespace ryosen {

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
  const auto chosen =
      std::find_if(row.choices.begin(), row.choices.end(), [&](const Choice& c) { return c.id == text; });
  if (row.kind == ParameterKind::choice) {
    const char* const shown = chosen == row.choices.end() ? "" : context.text(chosen->en, chosen->ja);
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
