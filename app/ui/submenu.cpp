#include "app/ui/submenu.h"

#include <imgui_internal.h>  // how wide the menu was, and where the one around lies

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace ryosen {

bool begin_submenu(const char* name, bool is_enabled) {
  char window[16];
  std::snprintf(window, sizeof window, "##Menu_%02d", GImGui->BeginMenuCount);  // as ImGui calls it
  const ImGuiWindow& around = *ImGui::GetCurrentWindow();
  const ImGuiWindow* const before = ImGui::FindWindowByName(window);
  const ImGuiStyle& style = ImGui::GetStyle();
  const float room = ImGui::GetIO().DisplaySize.x - style.DisplaySafeAreaPadding.x - around.Pos.x - around.Size.x;
  const float missing = before ? before->Size.x - room : 0, most = 0.6f * around.Size.x;
  // It overlaps the menu around by this gap.
  ImGui::PushStyleVar(ImGuiStyleVar_ItemInnerSpacing,
                      {std::clamp(std::ceil(missing), style.ItemInnerSpacing.x, most), style.ItemInnerSpacing.y});
  const bool is_open = ImGui::BeginMenu(name, is_enabled);
  ImGui::PopStyleVar();
  return is_open;
}

}  // namespace ryosen
