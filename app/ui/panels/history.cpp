#include "app/ui/panels.h"
#include "app/ui/widgets.h"

namespace ryosen {

namespace {

// The command that goes from the current history position to another.
std::string step_to(std::size_t position, std::size_t target) {
  return target < position ? "undo " + std::to_string(position - target) : "redo " + std::to_string(target - position);
}

// Every edit; a click goes back or forth to it.
class HistoryPanel : public Panel {
 public:
  void draw(PanelContext& context) override;

 private:
  std::size_t scrolled_position_ = 0;  // the place of the history that the list was scrolled to
};

void HistoryPanel::draw(PanelContext& context) {
  Session& session = context.session;
  const std::size_t position = session.document().position(), size = session.document().history().size();
  const float gap = 4 * context.scale, width = (ImGui::GetContentRegionAvail().x - gap) / 2;
  ImGui::BeginDisabled(position == 0);
  if (ImGui::Button(context.text(UiText::undo), {width, 0})) context.run("undo");
  ImGui::EndDisabled();
  ImGui::SameLine(0, gap);
  ImGui::BeginDisabled(position == size);
  if (ImGui::Button(context.text(UiText::redo), {width, 0})) context.run("redo");
  ImGui::EndDisabled();

  std::size_t target = position;
  const float line_height = ImGui::GetTextLineHeightWithSpacing();
  const float height = std::min(static_cast<float>(size + 1), 7.f) * line_height + 6 * context.scale;
  ImGui::BeginChild("entries", {0, height});
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(size) + 1, line_height);
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const auto place = static_cast<std::size_t>(i);
      const std::string label =
          place == 0 ? context.text(UiText::as_read) : session.document().history()[place - 1].command;
      ImGui::PushID(i);
      if (place > position) ImGui::PushStyleColor(ImGuiCol_Text, context.colours().dim);
      if (ImGui::Selectable(label.c_str(), place == position)) target = place;
      if (place > position) ImGui::PopStyleColor();
      ImGui::PopID();
    }
  }
  if (scrolled_position_ != position) ImGui::SetScrollY((static_cast<float>(position) - 3) * line_height);
  scrolled_position_ = position;
  ImGui::EndChild();
  if (target != position) context.run(step_to(position, target));
}

}  // namespace

std::unique_ptr<Panel> make_history_panel() { return std::make_unique<HistoryPanel>(); }

}  // namespace ryosen
