#include <algorithm>
#include <optional>
#include <utility>

#include "app/editor/command_syntax.h"
#include "app/editor/commands.h"
#include "app/editor/palette.h"
#include "app/editor/path_completion.h"
#include "app/editor/words.h"
#include "app/ui/panels.h"
#include "app/ui/widgets.h"

#include <imgui_stdlib.h>  // needs imgui.h before it

namespace ryosen {

namespace {

// A line with what it may say; Enter carries it out, or what is found first where it is no line.
class CommandPanel : public Panel {
 public:
  void draw(PanelContext& context) override;

 private:
  static int edit(ImGuiInputTextCallbackData* data);
  void follow_keys(ImGuiInputTextCallbackData& data);
  void find();
  void draw_found(PanelContext& context);
  std::optional<std::size_t> meant() const;
  void enter(PanelContext& context);
  void take(PanelContext& context, const PaletteEntry& entry);
  void run(PanelContext& context, const std::string& line);
  void type(std::string line);

  std::string typed_;
  std::optional<std::string> found_for_;
  std::vector<PaletteEntry> found_;
  int chosen_ = -1;                 // of what was found; -1: the line itself
  std::vector<std::string> lines_;  // that were carried out, the last one last
  std::size_t line_ = 0;            // of these, that stands in the field; lines_.size(): none
  bool takes_keys_ = false;         // the field is to have the keyboard
  bool goes_to_end_ = false;
};

// What a help says beyond its beginning, which is the name.
std::string beyond_name(const std::string& help, const std::string& name) {
  if (name.empty() || help.size() < name.size() || help.substr(1, name.size() - 1) != name.substr(1)) return help;
  std::string_view rest = std::string_view(help).substr(name.size());
  for (const std::string_view mark : {";", ":", "：", "。"})
    if (rest.starts_with(mark)) rest.remove_prefix(mark.size());
  return std::string(without_blanks(rest));
}

int CommandPanel::edit(ImGuiInputTextCallbackData* data) {
  static_cast<CommandPanel*>(data->UserData)->follow_keys(*data);
  return 0;
}

// Down and Up go through what was found, Up from the line itself to the lines before; Tab completes.
void CommandPanel::follow_keys(ImGuiInputTextCallbackData& data) {
  const auto put = [&](const std::string& line) {
    data.DeleteChars(0, data.BufTextLen);
    data.InsertChars(0, line.c_str());
  };
  const std::string typed(data.Buf, static_cast<std::size_t>(data.BufTextLen));
  const auto call = call_of(typed);
  const std::size_t word = typed.find(' ');
  const bool names_file = call && call->row.file != FileAccess::none && word != typed.npos;
  if (data.EventFlag == ImGuiInputTextFlags_CallbackCompletion && names_file) {
    std::error_code ignored;
    const std::string argument = file_name(typed.substr(word));
    const std::string path = completed_path(argument, std::filesystem::current_path(ignored));
    if (path != argument) put(typed.substr(0, word + 1) + file_argument(path));
  } else if (data.EventFlag == ImGuiInputTextFlags_CallbackCompletion && !found_.empty()) {
    put(found_[static_cast<std::size_t>(std::max(chosen_, 0))].line + " ");
    chosen_ = -1;
  } else if (data.EventFlag == ImGuiInputTextFlags_CallbackHistory) {
    const bool is_down = data.EventKey == ImGuiKey_DownArrow;
    const bool among_lines = line_ < lines_.size();
    if (is_down && among_lines)
      put(++line_ < lines_.size() ? lines_[line_] : "");
    else if (is_down)
      chosen_ = std::min(chosen_ + 1, static_cast<int>(found_.size()) - 1);
    else if (chosen_ >= 0)
      --chosen_;
    else if (line_ > 0)
      put(lines_[--line_]);
  } else if (std::exchange(goes_to_end_, false)) {
    data.CursorPos = data.SelectionStart = data.SelectionEnd = data.BufTextLen;
  }
}

void CommandPanel::find() {
  if (found_for_ == typed_) return;
  found_for_ = typed_;
  found_ = find_in_palette(typed_);
  chosen_ = -1;
}

void CommandPanel::type(std::string line) {
  typed_ = std::move(line);
  chosen_ = -1;
  takes_keys_ = true;
}

// Each a row and its help on one line, so that all lines end whole; the help of the only one stands there to its end.
void CommandPanel::draw_found(PanelContext& context) {
  const float pitch = ImGui::GetTextLineHeightWithSpacing(), indent = 10 * context.scale;
  begin_rows_within("suggestions", ImGui::GetContentRegionAvail().y);
  if (found_.empty()) dim_text(context, context.text(UiText::nothing_found));
  const auto enters = meant();
  std::optional<std::size_t> taken;
  for (std::size_t i = 0; i < found_.size(); ++i) {
    const PaletteEntry& entry = found_[i];
    const bool is_chosen = chosen_ == static_cast<int>(i);
    const std::string& name = entry.name.in(context.language());
    const std::string usage = entry.syntax.empty() ? entry.line : entry.line + " " + entry.syntax;
    const std::string shown = name == entry.line ? usage : name;
    const std::string right = name == entry.line ? chord_of(context.session, entry.line) : usage;
    const float top = ImGui::GetCursorPosY();
    ImGui::PushID(entry.line.c_str());
    if (row(context, shown.c_str(), right.c_str(), enters == i)) taken = i;
    ImGui::PopID();
    if (is_chosen) ImGui::SetScrollHereY();
    const std::string& help = entry.help.in(context.language());
    if (found_.size() == 1) {
      if (!entry.syntax.empty()) dim_text(context, usage.c_str());
      if (!help.empty()) dim_text(context, help.c_str());
      break;
    }
    ImGui::SetCursorPosY(top + pitch);
    const std::string more = beyond_name(help, name);
    if (more.empty()) continue;
    ImGui::Indent(indent);
    ImGui::PushStyleColor(ImGuiCol_Text, context.colours().dim);
    fitted_text(more, ImGui::GetContentRegionAvail().x);
    ImGui::PopStyleColor();
    ImGui::Unindent(indent);
    ImGui::SetCursorPosY(top + 2 * pitch);
  }
  end_rows();
  if (taken) take(context, PaletteEntry(found_[*taken]));
}

void CommandPanel::draw(PanelContext& context) {
  if (ImGui::IsWindowAppearing()) {
    type("");
    line_ = lines_.size();
  }
  if (!context.state.begun_command.empty()) type(std::exchange(context.state.begun_command, {}));
  if (std::exchange(takes_keys_, false)) {
    ImGui::SetKeyboardFocusHere();
    goes_to_end_ = true;
  }
  ImGui::SetNextItemWidth(-1);
  const bool entered =
      ImGui::InputTextWithHint("##command", context.text(UiText::command_hint), &typed_,
                               ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackAlways |
                                   ImGuiInputTextFlags_CallbackCompletion | ImGuiInputTextFlags_CallbackHistory,
                               &CommandPanel::edit, this);
  find();
  const Text& outcome = context.state.last_outcome;
  if (context.state.last_kind != Outcome::Kind::done && !outcome.en.empty()) {
    ImGui::PushTextWrapPos(0);
    coloured_text(context.colours().warning, outcome.in(context.language()).c_str());
    ImGui::PopTextWrapPos();
  }
  draw_found(context);
  if (entered) enter(context);
}

// Of what was found, that which Enter takes: what is chosen, else the first, where the line as it stands says nothing or
// lacks what the first asks for. None where the line is carried out.
std::optional<std::size_t> CommandPanel::meant() const {
  if (chosen_ >= 0) return static_cast<std::size_t>(chosen_);
  const std::string line(without_blanks(typed_));
  if (line.empty() || found_.empty()) return std::nullopt;
  const bool is_bare = found_[0].line == line;
  const AlgorithmRow* const algorithm = find_algorithm(line);
  const bool asks = is_bare && (find_op(line) || (algorithm && !algorithm->parameters.empty()));
  if (call_of(line) && !asks) return std::nullopt;
  return 0;
}

void CommandPanel::enter(PanelContext& context) {
  takes_keys_ = true;
  if (const auto i = meant()) return take(context, PaletteEntry(found_[*i]));
  if (!split_words(typed_).empty()) run(context, typed_);
}

void CommandPanel::take(PanelContext& context, const PaletteEntry& entry) {
  const PaletteChoice choice = choice_of(context.session, entry);
  if (choice.kind == PaletteChoice::Kind::begin) return type(choice.line);
  run(context, choice.line);
}

void CommandPanel::run(PanelContext& context, const std::string& line) {
  const std::string own = context.session.open_panel;
  if (!context.run(line).done()) {
    takes_keys_ = true;
    return;
  }
  std::erase(lines_, line);
  lines_.push_back(line);
  if (context.session.open_panel == own) context.session.open_panel.clear();
}

}  // namespace

std::unique_ptr<Panel> make_command_panel() { return std::make_unique<CommandPanel>(); }

}  // namespace ryosen
