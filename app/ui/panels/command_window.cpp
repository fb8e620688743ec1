#include <algorithm>

#include "app/editor/command_syntax.h"
#include "app/editor/commands.h"
#include "app/ui/panels/all.h"
#include "app/ui/widgets.h"

#include <imgui_stdlib.h>  // needs imgui.h before it

namespace ryosen {

namespace {

// What a line may begin with, as a row of the list.
struct Suggestion {
  std::string_view id, syntax, help;
};

std::vector<Suggestion> suggestions(const PanelContext& context) {
  const std::string& typed = context.state.command;
  const std::string_view word = std::string_view(typed).substr(0, typed.find(' '));
  const bool is_whole = word.size() < typed.size();
  std::vector<Suggestion> found;
  const auto add = [&](std::string_view id, std::string_view syntax, std::string_view help) {
    if (is_whole ? id == word : id.find(word) != std::string_view::npos) found.push_back({id, syntax, help});
  };
  for (const CommandRow& row : command_table()) add(row.id, row.syntax, context.text(row.help_en, row.help_ja));
  // What begins with the word comes before what only contains it.
  std::stable_partition(found.begin(), found.end(), [&](const Suggestion& s) { return s.id.starts_with(word); });
  return found;
}

// What is typed goes on behind what stands there already, in place of replacing it.
int go_to_end(ImGuiInputTextCallbackData* data) {
  bool& must_go = *static_cast<bool*>(data->UserData);
  if (must_go) data->CursorPos = data->SelectionStart = data->SelectionEnd = data->BufTextLen;
  must_go = false;
  return 0;
}

void draw_suggestions(PanelContext& context) {
  ImGui::BeginChild("suggestions");
  for (const Suggestion& s : suggestions(context)) {
    const std::string label = std::string(s.id) + " " + std::string(s.syntax);
    if (ImGui::Selectable(label.c_str())) context.state.command = std::string(s.id) + " ";
    dim_text(context, s.help.data());
  }
  ImGui::EndChild();
}

}  // namespace

void draw_command_window(PanelContext& context) {
  if (!begin_over(context, "command", context.text(UiText::command), {560, 360})) return;
  if (ImGui::IsWindowAppearing()) {
    ImGui::SetKeyboardFocusHere();
    context.state.command_was_begun = true;
  }
  ImGui::SetNextItemWidth(-1);
  const bool entered =
      ImGui::InputTextWithHint("##command", context.text(UiText::command_hint), &context.state.command,
                               ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackAlways, go_to_end,
                               &context.state.command_was_begun);
  const Text& outcome = context.state.last_outcome;
  if (context.state.last_kind != Outcome::Kind::done && !outcome.en.empty()) {
    ImGui::PushTextWrapPos(0);
    coloured_text(context.colours().warning, outcome.in(context.language()).c_str());
    ImGui::PopTextWrapPos();
  }
  draw_suggestions(context);
  end_over();
  if (!entered || split_words(context.state.command).empty()) return;
  const std::string line = context.state.command;
  // What would lose changes asks first.
  const auto call = call_of(line);
  if (context.session.document().is_modified() && call && call->row.effect == Effect::replaces &&
      !fault_of_command(line)) {
    context.state.command.clear();
    return context.leave({false, {}, line});
  }
  if (context.run(line).done()) {
    context.state.command.clear();
    if (context.session.open_panel == "command") context.session.open_panel.clear();
  }
}

}  // namespace ryosen
