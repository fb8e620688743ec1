#include <algorithm>
#include <string>
#include <vector>

#include "app/editor/camera/view_state.h"
#include "app/editor/session/selecting.h"
#include "app/editor/texts/remedy_text.h"
#include "app/ui/panels.h"
#include "app/ui/widgets.h"
#include "ryosen/mesh/mesh.h"

namespace ryosen {

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
