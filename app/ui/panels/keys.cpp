#include "app/editor/keys.h"
#include "app/ui/panels.h"
#include "app/ui/widgets.h"

namespace ryosen {

namespace {

void pair_row(PanelContext& context, const char* chord, const char* help) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  coloured_text(context.colours().accent, chord);
  ImGui::TableNextColumn();
  wrapped_text(help);
}

void draw_mouse(PanelContext& context) {
  const std::string middle = std::string(context.text(UiText::does_orbit)) +
                             " (Shift: " + context.text(UiText::does_pan) +
                             ", Ctrl: " + context.text(UiText::does_zoom) + ")";
  pair_row(context, context.text(UiText::left_button), context.text(UiText::does_orbit));
  pair_row(context, context.text(UiText::right_button), context.text(UiText::does_pan));
  pair_row(context, context.text(UiText::middle_button), middle.c_str());
  pair_row(context, context.text(UiText::wheel), context.text(UiText::does_zoom));
  pair_row(context, context.text(UiText::double_click), context.text(UiText::does_centre));
}

void draw_keys(PanelContext& context) {
  const auto table = [&](const char* id, float help_share, auto fill) {
    if (!ImGui::BeginTable(id, 2)) return;
    ImGui::TableSetupColumn("key", ImGuiTableColumnFlags_WidthStretch, 1);
    ImGui::TableSetupColumn("help", ImGuiTableColumnFlags_WidthStretch, help_share);
    fill();
    ImGui::EndTable();
  };
  const float height = ImGui::GetContentRegionAvail().y;
  const float half = ImGui::GetContentRegionAvail().x / 2 - 8 * context.scale;
  begin_rows_within("keys", height, half);
  dim_text(context, context.text(UiText::key));
  table("keys", 2.4f, [&] {
    for (const KeyRow& key : key_table(input_presets()[context.session.input_preset]))
      pair_row(context, key.chord.c_str(), context.text(key.help_en, key.help_ja));
  });
  end_rows();
  ImGui::SameLine(0, 16 * context.scale);
  begin_rows_within("mouse", height, half);
  dim_text(context, context.text(UiText::mouse));
  table("mouse", 1, [&] { draw_mouse(context); });
  end_rows();
}

}  // namespace

std::unique_ptr<Panel> make_keys_panel() { return panel_of(draw_keys, {760, 520}); }

}  // namespace ryosen
