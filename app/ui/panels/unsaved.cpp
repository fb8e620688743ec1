#include "app/ui/panels.h"
#include "app/ui/widgets.h"

namespace ryosen {

namespace {

// The question before changes would be lost.
class UnsavedPanel : public Panel {
 public:
  void draw(PanelContext& context) override;
  ImVec2 size() const override {
    return {440, (why_failed_.en.empty() ? 130.0f : 220.0f) + (is_changed_ ? 25.0f : 0.0f)};
  }

 private:
  Text why_failed_;          // to save, empty before
  bool is_changed_ = false;  // the file, by another program
};

void UnsavedPanel::draw(PanelContext& context) {
  if (ImGui::IsWindowAppearing()) {
    why_failed_ = {};
    context.session.look_at_disk();
  }
  // By the command `panel` it may be opened while nothing waits for the answer.
  if (!context.state.pending) return void(context.run("panel none"));
  const PendingLeave where = *context.state.pending;
  const std::string name = context.session.document().path().filename().string();
  const std::string of_file = name.empty() ? "" : name + context.text(": ", "：");
  ImGui::TextWrapped("%s%s", of_file.c_str(), context.text(UiText::unsaved_question));
  is_changed_ = context.session.change_on_disk() == FileState::Change::changed;
  if (is_changed_)
    coloured_text(context.colours().warning,
                  context.text("Another program has changed the file since it was read.",
                               "他のプログラムがこのファイルを変更しました。"));
  if (!why_failed_.en.empty()) coloured_text(context.colours().refused, why_failed_.in(context.language()).c_str());
  ImGui::Dummy({0, 10 * context.scale});
  const ImVec2 size{120 * context.scale, 0};
  if (ImGui::Button(is_changed_ ? context.text("Replace it", "上書き保存") : context.text(UiText::save), size)) {
    if (is_changed_) context.run("keep_mine");
    if (context.session.document().path().empty()) {
      context.open(PanelOpener::unnamed_save);
    } else {
      const Outcome saved = context.run("save");
      why_failed_ = saved.done() ? Text() : saved.sentence;
      if (saved.done()) context.go(where);
    }
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

std::unique_ptr<Panel> make_unsaved_panel() { return std::make_unique<UnsavedPanel>(); }

}  // namespace ryosen
