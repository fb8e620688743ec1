#include "app/editor/commands.h"
#include "app/ui/panels.h"
#include "app/ui/widgets.h"

namespace ryosen {

namespace {

// One session with its buttons; returns the chosen command, or empty.
std::string draw_lost(PanelContext& context, std::size_t n) {
  const LostSession& lost = context.session.lost[n];
  const std::string number = std::to_string(n + 1);
  std::string chosen;
  ImGui::PushID(static_cast<int>(n));
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(describe(lost).in(context.language()).c_str());
  ImGui::PopTextWrapPos();
  const ImVec2 size{120 * context.scale, 0};
  if (ImGui::Button(context.text(UiText::recover), size)) chosen = "recover " + number;
  ImGui::SameLine();
  if (ImGui::Button(context.text(UiText::discard), size)) chosen = "recover discard " + number;
  ImGui::Dummy({0, 4 * context.scale});
  ImGui::PopID();
  return chosen;
}

// What a crash left unsaved.
void draw_recover(PanelContext& context) {
  // Where the folder cannot be read, the command says why.
  if (ImGui::IsWindowAppearing() && !list_lost_sessions(context.session)) context.run("recover list");
  const std::vector<LostSession>& lost = context.session.lost;
  dim_text(context,
           lost.empty() ? nothing_to_recover().in(context.language()).c_str() : context.text(UiText::recover_question));
  ImGui::Dummy({0, 4 * context.scale});
  ImGui::BeginChild("lost", {0, -1.5f * ImGui::GetFrameHeightWithSpacing()}, false, ImGuiWindowFlags_NavFlattened);
  std::string chosen;
  for (std::size_t n = 0; n < lost.size(); ++n)
    if (std::string command = draw_lost(context, n); !command.empty()) chosen = std::move(command);
  ImGui::EndChild();
  const bool closes = ImGui::Button(context.text(UiText::later), {120 * context.scale, 0});
  if (closes) context.run("panel none");
  if (chosen.empty()) return;
  if (call_of(chosen)->row.effect == Effect::replaces) return context.leave({false, {}, chosen});
  context.run(chosen);
  if (lost.empty()) context.session.open_panel.clear();
}

}  // namespace

std::unique_ptr<Panel> make_recover_panel() { return panel_of(draw_recover, {560, 300}); }

}  // namespace ryosen
