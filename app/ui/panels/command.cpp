#include <algorithm>
#include <optional>
#include <utility>

#include "app/editor/commands/command_syntax.h"
#include "app/editor/commands/commands.h"
#include "app/editor/commands/palette.h"
#include "app/editor/commands/path_completion.h"
#include "app/editor/commands/text/words.h"
#include "app/editor/document/findings.h"
#include "app/editor/preferences/layout.h"
#include "app/editor/preferences/preference_values.h"
#include "app/editor/session/selecting.h"
#include "app/ui/panels.h"
#include "app/ui/whole_rows.h"
#include "app/ui/widgets.h"
#include "ryosen/algo/algorithm_table.h"

#include <imgui_stdlib.h>  // needs imgui.h before it

namespace ryosen {

namespace {

// How an entry is written: a row, and paragraphs below it.
struct WrittenEntry {
  std::string label, right;
  std::vector<std::string> below;
};

// Below its name its help to the end, and how the line is written where only one was found or the row has no room for
// it.
WrittenEntry write_entry(const PanelContext& context, const PaletteEntry& entry, bool is_whole, float width) {
  const std::string& name = entry.name.in(context.language());
  const std::string& help = entry.help.in(context.language());
  const std::string usage = entry.syntax.empty() ? entry.line : entry.line + " " + entry.syntax;
  const std::string beside = is_whole ? entry.line : usage;
  const bool is_named = name != entry.line;
  const auto fits = [&](const std::string& label, const std::string& right) {
    return row_width(context, label, right) <= width;
  };
  WrittenEntry written{is_named ? name : beside, is_named ? beside : chord_of(context.preferences, entry.line), {}};
  std::string usage_below = is_whole && !entry.syntax.empty() ? usage : "";
  if (!fits(written.label, written.right)) {
    written.label = is_named && fits(name, "") ? name : entry.line;
    written.right = is_named && fits(name, entry.line) ? entry.line : "";
    if (usage != written.label && usage != written.right) usage_below = usage;
  }
  written.below = {usage_below, is_whole ? help : beyond_name(help, written.label)};
  std::erase(written.below, "");
  return written;
}

// A line with what it may say; Enter carries it out, or what is found first where it is no line.
class CommandPanel : public Panel {
 public:
  void draw(PanelContext& context) override {
    if (sent_ || ImGui::IsWindowAppearing()) begin(context);
    if (!context.state.begun_command.empty()) type(std::exchange(context.state.begun_command, {}));
    if (std::exchange(takes_keys_, false) || is_left_alone("##command")) {
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
    draw_refusal(context);
    draw_found(context);
    if (entered) enter(context);
  }

 private:
  static int edit(ImGuiInputTextCallbackData* data) {
    static_cast<CommandPanel*>(data->UserData)->follow_keys(*data);
    return 0;
  }

  // Down and Up go through what was found, Up from the line itself to the lines before; Tab completes.
  void follow_keys(ImGuiInputTextCallbackData& data) {
    const auto put = [&](const std::string& line) {
      data.DeleteChars(0, data.BufTextLen);
      data.InsertChars(0, line.c_str());
    };
    const std::string typed(data.Buf, static_cast<std::size_t>(data.BufTextLen));
    const auto call = call_of(typed);
    const std::size_t word = typed.find(' ');
    const bool names_file = call && call->row->file != FileAccess::none && word != typed.npos;
    if (data.EventFlag == ImGuiInputTextFlags_CallbackCompletion && names_file) {
      std::error_code ignored;
      const std::string argument = file_name(typed.substr(word));
      const std::string path = completed_path(argument, std::filesystem::current_path(ignored));
      if (path != argument) put(typed.substr(0, word + 1) + file_argument(path));
    } else if (data.EventFlag == ImGuiInputTextFlags_CallbackCompletion && !found_.empty()) {
      put(found_[static_cast<std::size_t>(std::max(chosen_, 0))].line + " ");
      chosen_ = -1;
    } else if (data.EventFlag == ImGuiInputTextFlags_CallbackHistory) {
      scrolls_ = true;
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

  void find() {
    if (found_for_ == typed_) return;
    found_for_ = typed_;
    found_ = find_in_palette(typed_);
    chosen_ = -1;
  }

  // A row and its help. True when it was clicked.
  bool draw_entry(PanelContext& context, std::size_t i, bool is_marked) {
    const PaletteEntry& entry = found_[i];
    const bool is_whole = found_.size() == 1 || (i == 0 && is_begun());
    const float top = ImGui::GetCursorPosY(), width = ImGui::GetContentRegionAvail().x, indent = 10 * context.scale;
    const WrittenEntry written = write_entry(context, entry, is_whole, width);
    float below = 0;
    for (const std::string& part : written.below)
      below += wrapped_size(part, width - indent).y + ImGui::GetStyle().ItemSpacing.y;
    rows_.row_of_text();
    ImGui::PushID(entry.line.c_str());
    const bool taken = row(context, written.label.c_str(), written.right.c_str(), is_marked, 0, below);
    ImGui::PopID();
    if (chosen_ == static_cast<int>(i) && std::exchange(scrolls_, false)) ImGui::SetScrollHereY();
    ImGui::SetCursorPosY(top + ImGui::GetTextLineHeightWithSpacing());
    ImGui::Indent(indent);
    for (const std::string& part : written.below) dim_text(context, part.c_str());
    ImGui::Unindent(indent);
    return taken;
  }

  void draw_found(PanelContext& context) {
    rows_.begin("suggestions", ImGui::GetContentRegionAvail().y);
    if (found_.empty()) dim_text(context, context.text(UiText::nothing_found));
    const auto enters = meant();
    std::optional<std::size_t> taken;
    for (std::size_t i = 0; i < found_.size(); ++i)
      if (draw_entry(context, i, enters == i)) taken = i;
    rows_.end();
    if (taken) take(context, PaletteEntry(found_[*taken]));
  }

  // As long as what was refused stands there.
  void draw_refusal(PanelContext& context) {
    const bool is_other = refused_ && (chosen_ != refused_->chosen || command() != refused_->command);
    if (is_other) refused_.reset();
    const Text& outcome = context.state.last.sentence;
    if (!refused_ || context.state.last.kind == Outcome::Kind::done || outcome.en.empty()) return;
    ImGui::PushTextWrapPos(0);
    coloured_text(context.colours().warning, outcome.in(context.language()).c_str());
    ImGui::PopTextWrapPos();
  }

  // The first word.
  std::string command() const {
    const std::vector<std::string_view> words = split_words(typed_);
    return words.empty() ? "" : std::string(words[0]);
  }
  // What was typed names a command and goes on: that command comes first.
  bool is_begun() const { return !found_.empty() && typed_.starts_with(found_[0].line + " "); }

  // Of what was found, that which Enter takes: what is chosen, else the first, where the line as it stands says nothing
  // or lacks what the first asks for. None where the line is carried out.
  std::optional<std::size_t> meant() const {
    if (chosen_ >= 0) return static_cast<std::size_t>(chosen_);
    const std::string line(without_blanks(typed_));
    if (line.empty() || found_.empty()) return std::nullopt;
    const bool is_bare = found_[0].line == line;
    const AlgorithmRow* const algorithm = find_algorithm(line);
    const auto call = call_of(line);
    const bool is_about_elements = find_op(line) || (call && call->row->most_elements > 0);
    const bool lacks_something = fault_of_command(line).has_value();
    const bool asks = is_bare && (is_about_elements || (lacks_something && !is_begun()) ||
                                  (algorithm && !algorithm->parameters.empty()));
    // A word alone that lacks something gives way to what is called so.
    const bool is_name = found_[0].line != line && line.find(' ') == line.npos && lacks_something;
    // What is begun and lacks something is ended by the only one that goes on so.
    if (is_begun() && found_.size() == 2 && found_[1].line != line && lacks_something) return 1;
    if (call && !asks && !is_name) return std::nullopt;
    return 0;
  }

  // Empty, but for a line that took long, was refused, and has opened this again.
  void begin(PanelContext& context) {
    const std::optional<Refused> sent = std::exchange(sent_, std::nullopt);
    const bool is_refused = sent && context.state.last.kind != Outcome::Kind::done;
    type(is_refused ? typed_ : "");
    if (is_refused) {
      chosen_ = sent->chosen;
      refused_ = sent;
    }
    line_ = lines_.size();
  }

  void enter(PanelContext& context) {
    takes_keys_ = true;
    if (const auto i = meant()) return take(context, PaletteEntry(found_[*i]));
    if (!split_words(typed_).empty()) run(context, typed_);
  }

  void take(PanelContext& context, const PaletteEntry& entry) {
    const PaletteChoice choice = choice_of(context.findings(), context.selecting, entry);
    if (choice.kind == PaletteChoice::Kind::begin) return type(choice.line);
    run(context, choice.line);
  }

  void run(PanelContext& context, const std::string& line) {
    const std::string own = context.layout.open_panel;
    sent_ = Refused{command(), chosen_};
    if (!context.run(line, own).done()) {
      takes_keys_ = true;
      refused_ = std::exchange(sent_, std::nullopt);
      return;
    }
    std::erase(lines_, line);
    lines_.push_back(line);
    if (context.layout.open_panel == own) context.layout.open_panel.clear();
  }

  void type(std::string line) {
    typed_ = std::move(line);
    chosen_ = -1;
    takes_keys_ = true;
    refused_.reset();
  }

  std::string typed_;
  std::optional<std::string> found_for_;
  std::vector<PaletteEntry> found_;
  int chosen_ = -1;                 // of what was found; -1: the line itself
  std::vector<std::string> lines_;  // that were carried out, the last one last
  std::size_t line_ = 0;            // of these, that stands in the field; lines_.size(): none
  bool takes_keys_ = false;         // the field is to have the keyboard
  WholeRows rows_;                  // of what was found
  // What was chosen when it was refused, as long as nothing else is; and when it was sent.
  struct Refused {
    std::string command;
    int chosen;
  };
  std::optional<Refused> refused_, sent_;
  bool goes_to_end_ = false;
  bool scrolls_ = false;  // to what is chosen
};

}  // namespace

std::unique_ptr<Panel> make_command_panel() { return std::make_unique<CommandPanel>(); }

}  // namespace ryosen
