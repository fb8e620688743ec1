#include <algorithm>
#include <utility>

#include "app/editor/command_syntax.h"
#include "app/editor/commands.h"
#include "app/ui/panels.h"
#include "app/ui/widgets.h"

#include <imgui_stdlib.h>  // needs imgui.h before it

namespace ryosen {

namespace {

// The commands that a line may begin with.
std::vector<CommandRow> suggestions(const std::string& typed) {
  const std::string_view word = std::string_view(typed).substr(0, typed.find(' '));
  const bool is_whole = word.size() < typed.size();
  std::vector<CommandRow> found = command_table();
  std::erase_if(found,
                [&](const CommandRow& row) { return is_whole ? row.id != word : row.id.find(word) == row.id.npos; });
  // What begins with the word comes before what only contains it.
  std::stable_partition(found.begin(), found.end(), [&](const CommandRow& row) { return row.id.starts_with(word); });
  return found;
}

// What is typed goes on behind what stands there already, in place of replacing it.
int go_to_end(ImGuiInputTextCallbackData* data) {
  bool& must_go = *static_cast<bool*>(data->UserData);
  if (must_go) data->CursorPos = data->SelectionStart = data->SelectionEnd = data->BufTextLen;
  must_go = false;
  return 0;
}

void draw_suggestions(PanelContext& context, std::string& typed) {
  begin_rows_within("suggestions", ImGui::GetContentRegionAvail().y);
  for (const CommandRow& row : suggestions(typed)) {
    const std::string label = std::string(row.id) + " " + row.syntax;
    if (ImGui::Selectable(label.c_str())) typed = std::string(row.id) + " ";
    dim_text(context, help_of(row, context.language()).c_str());
  }
  end_rows();
}

// A line with what it may say; Enter carries it out.
class CommandPanel : public Panel {
 public:
  void draw(PanelContext& context) override;

 private:
  void enter(PanelContext& context);

  std::string typed_;
  bool was_begun_ = false;    // the field has just appeared
  bool was_refused_ = false;  // the text stays, and the field keeps the keyboard
};

void CommandPanel::draw(PanelContext& context) {
  if (!context.state.begun_command.empty()) typed_ = std::exchange(context.state.begun_command, {});
  if (ImGui::IsWindowAppearing() || std::exchange(was_refused_, false)) {
    ImGui::SetKeyboardFocusHere();
    was_begun_ = true;
  }
  ImGui::SetNextItemWidth(-1);
  const bool entered = ImGui::InputTextWithHint(
      "##command", context.text(UiText::command_hint), &typed_,
      ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackAlways, go_to_end, &was_begun_);
  const Text& outcome = context.state.last_outcome;
  if (context.state.last_kind != Outcome::Kind::done && !outcome.en.empty()) {
    ImGui::PushTextWrapPos(0);
    coloured_text(context.colours().warning, outcome.in(context.language()).c_str());
    ImGui::PopTextWrapPos();
  }
  draw_suggestions(context, typed_);
  if (entered) enter(context);
}

void CommandPanel::enter(PanelContext& context) {
  const std::string line = typed_;
  if (split_words(line).empty()) return;
  // What would lose changes asks first.
  const auto call = call_of(line);
  if (context.session.document().is_modified() && call && call->row.effect == Effect::replaces &&
      !fault_of_command(line)) {
    typed_.clear();
    return context.leave({false, {}, line});
  }
  const std::string own = context.session.open_panel;
  if (context.run(line).done()) {
    typed_.clear();
    if (context.session.open_panel == own) context.session.open_panel.clear();
  } else {
    was_refused_ = true;
  }
}

}  // namespace

std::unique_ptr<Panel> make_command_panel() { return std::make_unique<CommandPanel>(); }

}  // namespace ryosen
