// Where each figure, table, problem and listing of the source texts is found; a click shows it.
#include <algorithm>
#include <span>
#include <vector>

#include "app/editor/script.h"
#include "app/editor/text_places.h"
#include "app/ui/panels.h"
#include "app/ui/widgets.h"

namespace ryosen {

namespace {

class TextsPanel : public Panel {
 public:
  void draw(PanelContext& context) override;
  ImVec2 size() const override { return {940, 560}; }

 private:
  void draw_place(PanelContext& context, const TextPlace& place);
  void show(PanelContext& context, const TextPlace& place);

  const TextPlace* shown_ = nullptr;  // last
};

// Whether nothing was done but what shows a place.
bool is_as_shown(const Document& document, const TextPlace* place) {
  if (!place) return false;
  const std::vector<ScriptLine> lines = split_script(place->lines);
  const std::span<const HistoryEntry> history = document.history();
  return document.path().empty() && std::all_of(history.begin(), history.end(), [&](const HistoryEntry& entry) {
           return std::any_of(lines.begin(), lines.end(), [&](const auto& line) { return line.text == entry.command; });
         });
}

// Where edits would be lost it asks first, and shows nothing yet.
void TextsPanel::show(PanelContext& context, const TextPlace& place) {
  const Document& document = context.session.document();
  context.session.open_panel.clear();
  if (document.is_modified() && !is_as_shown(document, shown_)) return context.leave({false, {}, "new"});
  shown_ = &place;
  context.run_from("new", {});  // without asking again
  for (const ScriptLine& line : split_script(place.lines))
    if (!context.run(line.text).done()) return;
}

void TextsPanel::draw_place(PanelContext& context, const TextPlace& place) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const std::string name = context.text(place.place_en, place.place_ja),
                    shown = fitted(name, ImGui::GetContentRegionAvail().x);
  if (place.lines.empty())
    dim_text(context, shown.c_str());
  else if (link(context, shown.c_str()))
    show(context, place);
  tip(place.lines.empty() ? name : name + "\n" + std::string(place.lines));
  ImGui::TableNextColumn();
  wrapped_text(context.text(place.where_en, place.where_ja));
}

void TextsPanel::draw(PanelContext& context) {
  dim_text(context, context.text("A click shows it, in place of the mesh that is open.",
                                 "クリックすると、開いているメッシュの代わりに表示する。"));
  begin_rows_within("places", ImGui::GetContentRegionAvail().y);
  std::string_view text;
  bool is_open = false;  // the table of the text
  for (const TextPlace& place : text_places()) {
    if (place.text != text) {
      if (is_open) ImGui::EndTable();
      text = place.text;
      ImGui::PushFont(context.fonts.bold);
      ImGui::TextUnformatted((context.text("Text ", "テキスト ") + std::string(text)).c_str());
      ImGui::PopFont();
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

}  // namespace

std::unique_ptr<Panel> make_texts_panel() { return std::make_unique<TextsPanel>(); }

}  // namespace ryosen
