#include <algorithm>
#include <utility>

#include "app/editor/session/session.h"
#include "app/ui/panels.h"
#include "app/ui/widgets.h"

namespace ryosen {

namespace {

bool unsaved_button(PanelContext& context, const std::string& label) {
  const float text = ImGui::CalcTextSize(label.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
  return ImGui::Button(label.c_str(), {std::max(120 * context.scale, text), 0});
}

// The question before changes would be lost.
class UnsavedPanel : public Panel {
 public:
  void draw(PanelContext& context) override {
    if (ImGui::IsWindowAppearing()) {
      why_failed_ = {};
      is_safe_ = false;
      context.session.look_at_disk();
    }
    // By the command `panel` it may be opened while nothing waits for the answer.
    if (!context.state.pending) return void(context.run("panel none"));
    const PendingLeave where = *context.state.pending;
    ask(context);
    ImGui::Dummy({0, 10 * context.scale});
    if (is_changed_ && where.reads_again())
      draw_reading_again(context, where);
    else
      draw_leaving(context, where);
  }

  ImVec2 size() const override {
    return {is_changed_ ? 560.0f : 440.0f, (why_failed_.en.empty() ? 130.0f : 220.0f) + (is_changed_ ? 25.0f : 0.0f)};
  }

 private:
  void ask(PanelContext& context) {
    const std::string name = context.document().path().filename().string();
    const std::string of_file = name.empty() ? "" : name + context.text(": ", "：");
    ImGui::TextWrapped("%s%s", of_file.c_str(), context.text(UiText::unsaved_question));
    is_changed_ = context.session.change_on_disk() == FileState::Change::changed;
    is_safe_ = is_safe_ && is_changed_;
    if (is_changed_)
      coloured_text(context.colours().warning, context.text("Another program has changed the file since it was read.",
                                                            "他のプログラムがこのファイルを変更しました。"));
    if (!why_failed_.en.empty()) coloured_text(context.colours().refused, why_failed_.in(context.language()).c_str());
  }

  void draw_leaving(PanelContext& context, const PendingLeave& where) {
    if (unsaved_button(context, is_changed_ ? context.text("Replace it", "上書き保存") : context.text(UiText::save)))
      save(context, where);
    ImGui::SameLine();
    if (unsaved_button(context, context.text(UiText::discard))) context.go(where);
    ImGui::SameLine();
    draw_cancel(context);
  }

  void draw_reading_again(PanelContext& context, const PendingLeave& where) {
    const std::size_t edits = context.document().unsaved_edits().value_or(0);
    const std::string n = std::to_string(edits);
    const std::string en = edits == 0 ? "mine" : edits == 1 ? "1 edit" : n + " edits";
    const std::string ja = edits == 0 ? "こちら" : n + " 件の編集";
    if (unsaved_button(context, Text{"Reload and lose " + en, ja + "を捨てて読み直す"}.in(context.language())))
      context.go(where);
    ImGui::SameLine();
    if (unsaved_button(context, context.text("Save mine elsewhere...", "別名で保存..."))) {
      context.state.pending.reset();
      context.open(PanelOpener::unnamed_save);
      return;
    }
    ImGui::SameLine();
    draw_cancel(context);
  }

  // Where Enter would replace what another program has written, it is Cancel that has the keyboard.
  void draw_cancel(PanelContext& context) {
    if (is_changed_ && !std::exchange(is_safe_, true)) give_keyboard_to_next();
    if (!unsaved_button(context, context.text(UiText::cancel))) return;
    context.state.pending.reset();
    context.run("panel none");
  }

  void save(PanelContext& context, const PendingLeave& where) {
    if (is_changed_) context.run("keep_mine");
    if (context.document().path().empty()) {
      context.state.pending->awaits_name = true;
      context.open(PanelOpener::unnamed_save);
      return;
    }
    const Outcome saved = context.run("save");
    why_failed_ = saved.done() ? Text() : saved.sentence;
    if (saved.done()) context.go(where);
  }

  Text why_failed_;          // to save, empty before
  bool is_changed_ = false;  // the file, by another program
  bool is_safe_ = false;     // Cancel has had the keyboard since it is
};

}  // namespace

std::unique_ptr<Panel> make_unsaved_panel() { return std::make_unique<UnsavedPanel>(); }

}  // namespace ryosen
