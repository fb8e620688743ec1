#include "app/editor/remedy_text.h"
#include "app/ui/panels.h"
#include "app/ui/widgets.h"

namespace ryosen {

void draw_pointer_tip(PanelContext& context) {
  if (!context.session.hover() || !context.session.hover()->op) return;
  const Hover& hover = *context.session.hover();
  const bool legal = hover.preview.verdict.legal();
  if (legal && hover.preview.warnings.empty()) return;
  const Mesh& mesh = context.session.mesh();
  const float width = 21 * ImGui::GetFontSize();
  const ImVec2 offset{18 * context.scale, 16 * context.scale};
  const ImVec2 all = ImGui::GetIO().DisplaySize;
  glm::dvec2 pixel = hover.pixel;
  if (context.session.is_verdict_held()) {  // stays at the element when the camera moves
    const auto place = project(context.session.camera, context.session.view, hover.picked.place);
    if (!place) return;
    pixel = place->pixel + context.session.view_origin;
  }
  const ImVec2 at{static_cast<float>(pixel.x), static_cast<float>(pixel.y)};
  const double right = context.session.view_origin.x + context.session.view.width;
  const bool leftwards = at.x + offset.x + width > static_cast<float>(right);
  ImGui::SetNextWindowPos({leftwards ? at.x - offset.x : at.x + offset.x, at.y + offset.y}, 0,
                          {leftwards ? 1.f : 0.f, at.y > 0.72f * all.y ? 1.f : 0.f});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::PushStyleColor(ImGuiCol_Border, legal ? context.colours().warning : context.colours().refused);
  ImGui::Begin("##tip", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  const std::vector<Reason>& reasons = legal ? hover.preview.warnings : hover.preview.verdict.reasons;
  for (const Text& sentence : describe_first(mesh, reasons)) wrapped_text(sentence.in(context.language()), width);
  if (!legal) {
    std::string help;
    for (const std::string& line : context.session.hover_remedy()) help += (help.empty() ? "" : "; ") + line;
    if (help.empty()) help = without_remedy(hover.preview.verdict).in(context.language());
    help = context.text(UiText::remedy) + (": " + help);
    ImGui::PushStyleColor(ImGuiCol_Text, context.colours().accent);
    wrapped_text(help, width);
    ImGui::PopStyleColor();
  }
  ImGui::PopStyleVar();
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
}

}  // namespace ryosen
