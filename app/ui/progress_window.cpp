#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/ui/panels.h"
#include "app/ui/widgets.h"

namespace ryosen {

namespace {

// Of work whose end is not known: goes from side to side.
void draw_going_on() {
  const ImVec2 at = ImGui::GetCursorScreenPos(), size{ImGui::GetContentRegionAvail().x, ImGui::GetFrameHeight() / 3};
  const double half = std::fmod(ImGui::GetTime() / 1.2, 2.0);
  const float share = static_cast<float>(half < 1 ? half : 2 - half), block = 0.25f * size.x;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, ImGui::GetColorU32(ImGuiCol_FrameBg), 2);
  const float left = at.x + share * (size.x - block);
  list.AddRectFilled({left, at.y}, {left + block, at.y + size.y}, ImGui::GetColorU32(ImGuiCol_PlotHistogram), 2);
  ImGui::Dummy(size);
}

// What is done, and how much of it is.
std::string title_of(const WorkShown& work, Language language) {
  const bool is_japanese = language == Language::japanese;
  if (!work.share) return is_japanese ? "処理中" : "At work";
  const std::string percent = std::to_string(static_cast<int>(100 * *work.share)) + "%";
  const std::string name = work.says.en.empty() ? is_japanese ? "処理中" : "At work" : work.says.in(language);
  return name + (is_japanese ? "：" : ": ") + percent;
}

}  // namespace

bool draw_progress_window(Language language, float scale, const WorkShown& work) {
  const auto in = [&](const char* en, const char* ja) { return language == Language::japanese ? ja : en; };
  const ImVec2 all = ImGui::GetIO().DisplaySize, size{360 * scale, 110 * scale};
  ImGui::SetNextWindowPos({std::floor((all.x - size.x) / 2), std::floor((all.y - size.y) / 2)});
  ImGui::SetNextWindowSize(size);
  ImGui::SetNextWindowFocus();
  // Whatever lies behind it, it is seen where it ends.
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, std::max(std::round(2 * scale), 1.f));
  ImGui::PushStyleColor(ImGuiCol_Border, ImGui::GetStyleColorVec4(ImGuiCol_NavHighlight));
  ImGui::Begin((title_of(work, language) + "###progress").c_str(), nullptr,
               ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                   ImGuiWindowFlags_NoSavedSettings);
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  if (work.share) {
    ImGui::ProgressBar(static_cast<float>(*work.share), {-1, 0}, "");
  } else {
    fitted_text(work.says.in(language), ImGui::GetContentRegionAvail().x);
    draw_going_on();
  }
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
