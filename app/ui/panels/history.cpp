#include "app/editor/commands/text/words.h"
#include "app/editor/shown/levels.h"
#include "app/editor/shown/shown.h"
#include "app/ui/panels.h"
#include "app/ui/widgets.h"
#include "ryosen/document/document.h"

namespace ryosen {

namespace {

// The command that goes from the current history position to another.
std::string step_to(std::size_t position, std::size_t target) {
  return target < position ? "undo " + std::to_string(position - target) : "redo " + std::to_string(target - position);
}

// Every edit; a click goes back or forth to it.
class HistoryPanel : public Panel {
 public:
  void draw(PanelContext& context) override {
    const std::size_t position = context.document().position(), size = context.document().history().size();
    const float gap = 4 * context.scale, width = (ImGui::GetContentRegionAvail().x - gap) / 2;
    ImGui::BeginDisabled(position == 0 && context.shown.response(Effect::steps) != Response::instead);
    if (ImGui::Button(context.text(UiText::undo), {width, 0})) context.run("undo");
    tip(context.text("Takes the last edit back, exactly.", "最後の編集を完全に元に戻します。"),
        ImGuiHoveredFlags_AllowWhenDisabled);
    ImGui::EndDisabled();
    ImGui::SameLine(0, gap);
    ImGui::BeginDisabled(position == size);
    if (ImGui::Button(context.text(UiText::redo), {width, 0})) context.run("redo");
    tip(context.text("Does again what was taken back.", "元に戻した編集をもう一度行います。"),
        ImGuiHoveredFlags_AllowWhenDisabled);
    ImGui::EndDisabled();

    std::size_t target = position;
    // Before the list scrolls to a whole row.
    const float scrolled = (static_cast<float>(position) - 3) * ImGui::GetTextLineHeightWithSpacing();
    list_of_rows(
        "entries", size + 1, 7,
        [&](std::size_t place) {
          const std::string label =
              place == 0 ? context.text(UiText::as_read) : context.document().history()[place - 1].command;
          const std::string shown = fitted(with_short_numbers(label), ImGui::GetContentRegionAvail().x);
          if (place > position) ImGui::PushStyleColor(ImGuiCol_Text, context.colours().dim);
          if (ImGui::Selectable((shown + "###entry").c_str(), place == position)) target = place;
          if (place > position) ImGui::PopStyleColor();
          const char* const help = context.text("A click goes to this state.", "クリックするとこの時点に移ります。");
          tip(shown != label ? label + "\n" + help : help);
        },
        scrolled_position_ == position ? std::nullopt : std::optional(scrolled));
    scrolled_position_ = position;
    if (target != position) context.run(step_to(position, target));
  }

 private:
  std::size_t scrolled_position_ = 0;  // the place of the history that the list was scrolled to
};

}  // namespace

std::unique_ptr<Panel> make_history_panel() { return std::make_unique<HistoryPanel>(); }

}  // namespace ryosen
