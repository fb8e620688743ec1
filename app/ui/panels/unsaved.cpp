#include "app/ui/panels.h"

namespace ryosen {

namespace {

// The question before changes would be lost.
void draw_unsaved(PanelContext& context) {
  // By the command `panel` it may be opened while nothing waits for the answer.
  if (!context.state.pending) return void(context.run("panel none"));
  const PendingLeave where = *context.state.pending;
  const std::string name = context.session.document().path().filename().string();
  const std::string of_file = name.empty() ? "" : name + context.text(": ", "：");
  ImGui::TextWrapped("%s%s", of_file.c_str(), context.text(UiText::unsaved_question));
  ImGui::Dummy({0, 10 * context.scale});
  const ImVec2 size{120 * context.scale, 0};
  if (ImGui::Button(context.text(UiText::save), size)) {
    if (context.session.document().path().empty())
      context.open(PanelOpener::unnamed_save);
    else if (context.run("save").done())
      context.go(where);
  }
  ImGui::SameLine();
  if (ImGui::Button(context.text(UiText::discard), size)) context.go(where);
  ImGui::SameLine();
  if (ImGui::Button(context.text(UiText::cancel), size)) {
    context.state.pending.reset();
    context.run("panel none");
  }
}

}  // namespace

std::unique_ptr<Panel> make_unsaved_panel() { return panel_of(draw_unsaved, {440, 130}); }

}  // namespace ryosen
