// Tooltips, where they cover nothing that is to be clicked next; and what stands beside the pointer.
#include <imgui_internal.h>  // which window an item belongs to

#include <algorithm>
#include <string>
#include <vector>

#include "app/editor/camera/view_state.h"
#include "app/editor/session/selecting.h"
#include "app/editor/texts/remedy_text.h"
#include "app/ui/panels.h"
#include "app/ui/side_columns.h"
#include "app/ui/widgets.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

namespace {

// Where what is told of an item goes where there is no room beside its panel: a row above it, so that what follows may
// be clicked next, else a row below it. So that both its neighbours are seen.
ImVec2 place_over_panel(ImVec2 first, ImVec2 last, ImVec2 size) {
  const ImVec2 all = ImGui::GetIO().DisplaySize;
  const float row = ImGui::GetFrameHeightWithSpacing(), above = first.y - row - size.y, below = last.y + row;
  const bool goes_above = above >= 0 || first.y > all.y - last.y;
  return {std::max(0.f, std::min(first.x, all.x - size.x)), goes_above ? std::max(above, 0.f) : below};
}

// Where the keyboard is at an item, the next ones are those around it: as far away from it as can be.
ImVec2 place_away(ImVec2 first, ImVec2 last, ImVec2 size) {
  const ImVec2 all = ImGui::GetIO().DisplaySize;
  const bool goes_below = all.y - last.y >= first.y;
  return {std::max(0.f, std::min(first.x, all.x - size.x)), goes_below ? all.y - size.y : 0};
}

// The room beside a panel, as far as the other column.
struct Beside {
  float begin, end;
};
Beside beside(const ImGuiWindow& panel, bool goes_right) {
  const float all = ImGui::GetIO().DisplaySize.x;
  Beside room = goes_right ? Beside{panel.Pos.x + panel.Size.x, all} : Beside{0, panel.Pos.x};
  const ImGuiWindow* const other =
      ImGui::FindWindowByName(column_window(goes_right ? PanelPlace::right : PanelPlace::left));
  const bool is_over_all = (panel.Flags & ImGuiWindowFlags_Popup) != 0;
  if (!other || other == &panel || !other->WasActive || is_over_all) return room;
  if (goes_right)
    room.end = std::max(room.begin, other->Pos.x);
  else
    room.begin = std::min(room.end, other->Pos.x + other->Size.x);
  return room;
}

}  // namespace

void tip(std::string_view text, ImGuiHoveredFlags hovered) {
  if (ImGui::IsItemHovered(hovered)) tip_shown(text);
}

void tip_shown(std::string_view text) {
  const ImGuiWindow& panel = *ImGui::GetCurrentWindow()->RootWindow;
  const ImVec2 all = ImGui::GetIO().DisplaySize, first = ImGui::GetItemRectMin();
  ImVec2 last = ImGui::GetItemRectMax();
  last.y = std::min(last.y, all.y);  // of what is scrolled, a part may lie below the window
  const float em = ImGui::GetFontSize(), gap = em / 2;
  const bool goes_right = all.x - panel.Pos.x - panel.Size.x >= panel.Pos.x;
  const Beside free = beside(panel, goes_right);
  const float room = free.end - free.begin - 2 * gap - 2 * ImGui::GetStyle().WindowPadding.x;
  const bool is_beside = room > 8 * em;
  const float width = is_beside ? std::min(22 * em, room) : 22 * em;
  if (!is_beside) {
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    const ImVec2 inside = wrapped_size(text, width), padding = ImGui::GetStyle().WindowPadding;
    ImGui::PopStyleVar();
    const ImVec2 size{inside.x + 2 * padding.x, inside.y + 2 * padding.y};
    const bool is_of_keyboard = GImGui->NavDisableMouseHover;
    ImGui::SetNextWindowPos(is_of_keyboard ? place_away(first, last, size) : place_over_panel(first, last, size));
  }
  if (is_beside) {
    const bool hangs = first.y < 0.6f * all.y;
    ImGui::SetNextWindowPos({goes_right ? free.begin + gap : free.end - gap, hangs ? first.y : last.y}, 0,
                            {goes_right ? 0.f : 1.f, hangs ? 0.f : 1.f});
  }
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, 1);  // also of what is faded
  ImGui::BeginTooltip();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  wrapped_text(text, width);
  ImGui::PopStyleVar(2);
  ImGui::EndTooltip();
}

namespace {

struct TipPart {
  std::string text;
  ImVec4 colour;
};

// What stands against what a click would do, and the remedy.
std::vector<TipPart> parts_of_tip(PanelContext& context, const Preview& preview) {
  const bool legal = preview.verdict.legal();
  const std::vector<Reason>& reasons = legal ? preview.warnings : preview.verdict.reasons;
  std::vector<TipPart> parts;
  for (const Text& sentence : describe_first(context.mesh(), reasons))
    parts.push_back({sentence.in(context.language()), ImGui::GetStyleColorVec4(ImGuiCol_Text)});
  if (legal) return parts;
  std::string help;
  for (const std::string& line : context.selecting.hover_remedy()) help += (help.empty() ? "" : "; ") + line;
  if (help.empty()) help = without_remedy(preview.verdict).in(context.language());
  parts.push_back({context.text(UiText::remedy) + (": " + help), context.colours().accent});
  return parts;
}

// Where the pointer is; of a verdict that is held where its element is, which the camera may have moved.
std::optional<glm::dvec2> place_of_tip(const ViewState& view, const Selecting& selecting) {
  if (!selecting.is_verdict_held()) return selecting.hover()->pixel;
  const auto place = project(view.camera, view.size, selecting.hover()->picked.place);
  if (!place) return std::nullopt;
  return place->pixel + view.origin;
}

ImVec2 size_of_tip(const std::vector<TipPart>& parts, float width) {
  const ImVec2 padding = ImGui::GetStyle().WindowPadding;
  ImVec2 size;
  for (const TipPart& part : parts) {
    const ImVec2 lines = wrapped_size(part.text, width);
    size = {std::max(size.x, lines.x), size.y + lines.y};
  }
  return {size.x + 2 * padding.x, size.y + 2 * padding.y};
}

}  // namespace

// Its size is known before it is drawn: what sizes itself to its content does so a frame later, and the next frame may
// come only once the view has rested.
void draw_pointer_tip(PanelContext& context) {
  if (!context.selecting.hover() || !context.selecting.hover()->op) return;
  const Preview& preview = context.selecting.hover()->preview;
  const bool legal = preview.verdict.legal();
  if (legal && preview.warnings.empty()) return;
  const auto pixel = place_of_tip(context.view, context.selecting);
  if (!pixel) return;
  const std::vector<TipPart> parts = parts_of_tip(context, preview);
  const float width = 21 * ImGui::GetFontSize();
  const ImVec2 offset{18 * context.scale, 16 * context.scale}, all = ImGui::GetIO().DisplaySize;
  const ImVec2 at{static_cast<float>(pixel->x), static_cast<float>(pixel->y)};
  const double right = context.view.origin.x + context.view.size.width;
  const bool leftwards = at.x + offset.x + width > static_cast<float>(right);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  ImGui::SetNextWindowSize(size_of_tip(parts, width));
  ImGui::SetNextWindowPos({leftwards ? at.x - offset.x : at.x + offset.x, at.y + offset.y}, 0,
                          {leftwards ? 1.f : 0.f, at.y > 0.72f * all.y ? 1.f : 0.f});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::PushStyleColor(ImGuiCol_Border, legal ? context.colours().warning : context.colours().refused);
  ImGui::Begin("##tip", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing);
  for (const TipPart& part : parts) {
    ImGui::PushStyleColor(ImGuiCol_Text, part.colour);
    wrapped_text(part.text, width);
    ImGui::PopStyleColor();
  }
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(2);
}

}  // namespace ryosen
