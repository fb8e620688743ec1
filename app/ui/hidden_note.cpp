#include "app/editor/hidden_text.h"
#include "app/ui/panels.h"
#include "app/ui/widgets.h"

namespace ryosen {

void draw_hidden_note(PanelContext& context) {
  const Session& session = context.session;
  context.state.note = {};
  if (session.hidden().empty()) return;
  const float margin = 12 * context.scale;
  ImGui::SetNextWindowPos({static_cast<float>(session.view_origin.x) + margin,
                           static_cast<float>(session.view_origin.y + session.view.height) - margin},
                          0, {0, 1});
  ImGui::Begin("##hidden", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoBringToFrontOnFocus |
                   ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoMove);
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(hidden_text(session.hidden()).in(context.language()).c_str());
  ImGui::SameLine();
  if (ImGui::Button(context.text(UiText::unhide))) context.run("unhide");
  tip(context.text("Shows again what is hidden.", "非表示にした要素をすべて表示します。") + std::string(" ") +
      chord_of(session, "unhide"));
  const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  context.state.note = {static_cast<int>(at.x), static_cast<int>(at.y), static_cast<int>(at.x + size.x),
                        static_cast<int>(at.y + size.y)};
  ImGui::End();
}

}  // namespace ryosen
