// Where each figure, table, problem and listing of the source texts is found; a click shows it.
#include "app/editor/textbook/text_places.h"
#include "app/ui/panels.h"
#include "app/ui/widgets.h"

namespace ryosen {

namespace {

class TextsPanel : public Panel {
 public:
  void draw(PanelContext& context) override {
    dim_text(context, context.text("A click shows it, in place of the mesh that is open.",
                                   "クリックすると、開いているメッシュの代わりに表示する。"));
    begin_rows_within("places", ImGui::GetContentRegionAvail().y);
    std::string_view text;
    bool is_open = false;  // the table of the text
    for (const TextPlace& place : text_places()) {
      if (place.text != text) {
        if (is_open) ImGui::EndTable();
        text = place.text;
        bold_text(context, (context.text("Text ", "テキスト ") + std::string(text)).c_str());
        is_open = ImGui::BeginTable(std::string(text).c_str(), 2);
        if (is_open) {
          ImGui::TableSetupColumn("place", ImGuiTableColumnFlags_WidthStretch, 1);
          ImGui::TableSetupColumn("where", ImGuiTableColumnFlags_WidthStretch, 1.1f);
        }
      }
      if (!is_open) continue;
      ImGui::PushID(&place);
      draw_place(context, place);
      ImGui::PopID();
    }
    if (is_open) ImGui::EndTable();
    end_rows();
  }

  ImVec2 size() const override { return {940, 560}; }

 private:
  void draw_place(PanelContext& context, const TextPlace& place) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const std::string name = context.text(place.place_en, place.place_ja),
                      shown = fitted(name, ImGui::GetContentRegionAvail().x);
    if (place.lines.empty())
      dim_text(context, shown.c_str());
    else if (link(context, shown.c_str()))
      context.leave({.command = "new; " + std::string(place.lines)});
    tip(place.lines.empty() ? name : name + "\n" + std::string(place.lines));
    ImGui::TableNextColumn();
    wrapped_text(context.text(place.where_en, place.where_ja));
  }
};

}  // namespace

std::unique_ptr<Panel> make_texts_panel() { return std::make_unique<TextsPanel>(); }

}  // namespace ryosen
