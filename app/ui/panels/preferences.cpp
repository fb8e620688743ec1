// What the window keeps for the next time: a field per row of the table of preferences.
#include "app/editor/preferences/preferences.h"

#include <algorithm>
#include <cmath>

#include "app/ui/panels.h"
#include "app/ui/widgets.h"

namespace ryosen {

namespace {

class PreferencesPanel : public Panel {
 public:
  void draw(PanelContext& context) override {
    if (ImGui::IsWindowAppearing()) {
      edited_.clear();
      fault_ = {};
    }
    const float pitch = ImGui::GetFrameHeight() + 2 * ImGui::GetStyle().CellPadding.y;
    const float room = ImGui::GetContentRegionAvail().y - 2.2f * ImGui::GetFrameHeightWithSpacing();
    begin_rows("rows", std::max(std::floor(room / pitch), 1.f), 0, pitch);
    if (ImGui::BeginTable("preferences", 3)) {
      ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch, 1);
      ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch, 1.6f);
      ImGui::TableSetupColumn("reset", ImGuiTableColumnFlags_WidthFixed);
      for (const PreferenceRow& row : preference_table()) draw_row(context, row);
      ImGui::EndTable();
    }
    end_rows(pitch);
    if (fault_.en.empty())
      dim_text(context, context.text("Kept for the next time, as are the panels and their places.",
                                     "次回も使います。パネルの配置も同様です。"));
    else
      coloured_text(context.colours().warning, fault_.in(context.language()).c_str());
    if (ImGui::Button(context.text("Keys...", "キー..."))) context.run("panel keys");
    ImGui::SameLine();
    if (ImGui::Button(context.text("Reset all", "すべて戻す"))) context.run("prefer all initial");
    ImGui::SameLine();
    if (ImGui::Button(context.text("Close", "閉じる"))) context.run("panel none");
  }

  // Of all rows at the usual size of letters.
  ImVec2 size() const override { return {560, 110 + 27 * static_cast<float>(preference_table().size())}; }

 private:
  void draw_row(PanelContext& context, const PreferenceRow& row) {
    const std::string id(row.field.id), value = row.value(context.session);
    ImGui::PushID(id.c_str());
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(context.text(row.field.name_en, row.field.name_ja));
    tip(context.text(row.field.help_en, row.field.help_ja));
    ImGui::TableNextColumn();
    std::string text = edited_ == id ? text_ : value;
    ImGui::SetNextItemWidth(-1);
    const bool entered = draw_parameter_field(context, row.field, text);
    const bool is_chosen = row.field.kind == ParameterKind::choice;
    tip(context.text(row.field.help_en, row.field.help_ja));
    if (ImGui::IsItemActive() && !is_chosen) {
      edited_ = id;
      text_ = text;
    }
    if (entered || ImGui::IsItemDeactivatedAfterEdit() || (is_chosen && text != value)) {
      const auto fault = fault_of_preference(id, text);
      fault_ = fault.value_or(Text());
      if (!fault) {
        edited_.clear();
        context.run("prefer " + id + " " + text);
      }
    }
    ImGui::TableNextColumn();
    ImGui::BeginDisabled(value == row.field.initial && edited_ != id);
    if (ImGui::Button(context.text("Reset", "戻す"))) {
      edited_.clear();
      fault_ = {};
      context.run("prefer " + id + " initial");
    }
    ImGui::EndDisabled();
    ImGui::PopID();
  }

  // What stands in the field that is being written into; a value that is none stays there with the reason.
  std::string edited_, text_;
  Text fault_;
};

}  // namespace

std::unique_ptr<Panel> make_preferences_panel() { return std::make_unique<PreferencesPanel>(); }

}  // namespace ryosen
