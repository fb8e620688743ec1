#include "app/editor/commands/commands.h"
#include "app/editor/session/session.h"
#include "app/ui/panels.h"
#include "app/ui/widgets.h"

namespace ryosen {

namespace {

// Where the file is another one by now: what has become of it, and a button for each way to recover; returns what the
// chosen one adds to the command, or empty.
std::string draw_choices(PanelContext& context, const LostSession& lost) {
  std::string chosen;
  coloured_text(context.colours().warning, told_change(lost, lost.change).in(context.language()).c_str());
  const auto choice = [&](const char* label, const char* word, const char* what) {
    if (ImGui::Button(label)) chosen = word;
    tip(what);
    ImGui::SameLine();
  };
  if (can_be_as_was(lost))
    choice(context.text("Recover as it was", "当時のメッシュで復元"), " as_was",
           context.text("Does the edits again on the mesh that they were made on. The file stays as it is now.",
                        "編集をしたときのメッシュに復元します。ファイルは今のまま残ります。"));
  if (can_be_as_is(lost))
    choice(context.text("Redo on the file as it is", "今のファイルでやり直す"), " as_is",
           context.text("Does the edits again on what the other program has written.",
                        "他のプログラムが書いた内容に対して編集をやり直します。"));
  return chosen;
}

// One session with its buttons; returns the chosen command, or empty.
std::string draw_lost(PanelContext& context, std::size_t n) {
  const LostSession& lost = context.session.lost[n];
  const std::string number = std::to_string(n + 1);
  std::string chosen;
  ImGui::PushID(static_cast<int>(n));
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(describe(lost).in(context.language()).c_str());
  ImGui::PopTextWrapPos();
  const ImVec2 size{120 * context.scale, 0};
  if (lost.change == FileState::Change::none) {
    if (ImGui::Button(context.text(UiText::recover), size)) chosen = "recover " + number;
    ImGui::SameLine();
  } else if (std::string line = draw_choices(context, lost); !line.empty()) {
    chosen = "recover " + number + line;
  }
  if (ImGui::Button(context.text(UiText::discard), size)) chosen = "recover discard " + number;
  ImGui::Dummy({0, 4 * context.scale});
  ImGui::PopID();
  return chosen;
}

// What a crash left unsaved.
class RecoverPanel : public Panel {
 public:
  void draw(PanelContext& context) override {
    // Where the folder cannot be read, the command says why.
    if (context.state.last.kind == Outcome::Kind::done) has_chosen_ = false;
    if (ImGui::IsWindowAppearing() && !list_lost_sessions(context.session.lost)) context.run("recover list");
    const std::vector<LostSession>& lost = context.session.lost;
    dim_text(context, lost.empty() ? nothing_to_recover().in(context.language()).c_str()
                                   : context.text(UiText::recover_question));
    ImGui::Dummy({0, 4 * context.scale});
    ImGui::BeginChild("lost", {0, -1.5f * ImGui::GetFrameHeightWithSpacing()}, false, ImGuiWindowFlags_NavFlattened);
    std::string chosen;
    for (std::size_t n = 0; n < lost.size(); ++n)
      if (std::string command = draw_lost(context, n); !command.empty()) chosen = std::move(command);
    if (has_chosen_ && context.state.last.kind != Outcome::Kind::done)
      coloured_text(context.colours().refused, context.state.last.sentence.in(context.language()).c_str());
    ImGui::EndChild();
    const bool closes = ImGui::Button(context.text(UiText::later), {120 * context.scale, 0});
    if (closes) context.run("panel none");
    if (chosen.empty()) return;
    has_chosen_ = true;
    if (call_of(chosen)->effect == Effect::replaces) {
      const std::string own(panel_opened_by(PanelOpener::lost_sessions).id);
      return context.leave({.command = chosen, .asks_again = own});
    }
    context.run(chosen);
    if (lost.empty()) context.layout.open_panel.clear();
  }

  ImVec2 size() const override { return {560, 300}; }

 private:
  bool has_chosen_ = false;  // where that failed, the reason stands in the panel
};

}  // namespace

std::unique_ptr<Panel> make_recover_panel() { return std::make_unique<RecoverPanel>(); }

}  // namespace ryosen
