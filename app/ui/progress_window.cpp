#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/ui/panels.h"
#include "app/ui/widgets.h"

namespace ryosen {

bool draw_progress_window(Language language, float scale, double share) {
  const auto in = [&](const char* en, const char* ja) { return language == Language::japanese ? ja : en; };
  const ImVec2 all = ImGui::GetIO().DisplaySize, size{360 * scale, 110 * scale};
  ImGui::SetNextWindowPos({std::floor((all.x - size.x) / 2), std::floor((all.y - size.y) / 2)});
  ImGui::SetNextWindowSize(size);
  ImGui::SetNextWindowFocus();
  // Whatever lies behind it, it is seen where it ends.
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, std::max(std::round(2 * scale), 1.f));
  ImGui::PushStyleColor(ImGuiCol_Border, ImGui::GetStyleColorVec4(ImGuiCol_NavHighlight));
  ImGui::Begin((std::string(in("At work", "処理中")) + "###progress").c_str(), nullptr,
               ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                   ImGuiWindowFlags_NoSavedSettings);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  ImGui::ProgressBar(static_cast<float>(share), {-1, 0});
  ImGui::Dummy({0, 6 * scale});
  const bool wants_cancel = ImGui::Button(in("Cancel (Esc)", "中止 (Esc)"), {120 * scale, 0});
  ImGui::End();
  return wants_cancel;
}

void draw_preparing(PanelContext& context, double share) {
  dim_text(context, context.text("Looking at the mesh", "メッシュを調べています"));
  ImGui::ProgressBar(static_cast<float>(share), {-1, 0});
}

}  // namespace ryosen
