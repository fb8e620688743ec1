#include <algorithm>
#include <utility>

#include "app/editor/commands/path_completion.h"
#include "app/editor/commands/text/words.h"
#include "app/editor/preferences/layout.h"
#include "app/ui/panels.h"
#include "app/ui/widgets.h"
#include "ryosen/document/document.h"
#include "ryosen/io/formats.h"
// clang-format off
#include <imgui_stdlib.h>  // needs imgui.h before it
// clang-format on

namespace ryosen {

namespace {

namespace fs = std::filesystem;

// What is done with the file that is chosen.
struct FileUse {
  std::string_view command;
  const char *button_en, *button_ja;
  bool writes;
  bool replaces;  // the open mesh: unsaved changes would be lost
  bool is_whole;  // it is written whole, under the name that is offered
};
constexpr FileUse to_open{"open", "Open", "開く", false, true, false};
constexpr FileUse to_append{"append", "Append", "追加で開く", false, false, false};
constexpr FileUse to_compare{"compare", "Compare", "比較", false, false, false};
constexpr FileUse to_save{"save", "Save", "保存", true, false, true};
constexpr FileUse to_save_selected{"save_selected", "Save", "保存", true, false, false};

// A folder, what is in it, and the name in the field, which has the keyboard: Up and Down go through the entries, Tab
// completes a path, goes into a folder and on from the field where there is no more of it, Enter takes it.
class FileBrowser : public Panel {
 public:
  explicit FileBrowser(const FileUse& use) : use_(use) {}

  void draw(PanelContext& context) override {
    if (ImGui::IsWindowAppearing()) begin(context.document());
    if (ImGui::Button(context.text(UiText::folder_up))) {
      go_to(folder_.parent_path());
      takes_keys_ = true;
    }
    ImGui::SameLine();
    ImGui::PushStyleColor(ImGuiCol_Text, context.colours().dim);
    fitted_text(folder_.string(), ImGui::GetContentRegionAvail().x);
    ImGui::PopStyleColor();
    const bool shows_losses = use_.is_whole && loses_ == chosen() && !losses_.empty();
    const float rows = 2.0f + (shows_losses ? 1.0f + 1.5f * static_cast<float>(losses_.size()) : 0.0f);
    const std::string why = failed_ == chosen() ? why_failed_.in(context.language()) : "";
    const float width = ImGui::GetContentRegionAvail().x;
    const float below =
        std::min(rows, 10.0f) * ImGui::GetFrameHeightWithSpacing() +
        (why.empty() ? 0
                     : ImGui::CalcTextSize(why.c_str(), nullptr, false, width).y + 2 * ImGui::GetStyle().ItemSpacing.y);
    const float bottom = ImGui::GetCursorPosY() + ImGui::GetContentRegionAvail().y - below;
    begin_rows_within("entries", bottom - ImGui::GetCursorPosY());
    bool accepted = draw_entries(context);
    end_rows();
    ImGui::SetCursorPosY(bottom + ImGui::GetStyle().ItemSpacing.y);
    accepted |= draw_name(context);
    accepted |= ImGui::Button(context.text(use_.button_en, use_.button_ja));
    ImGui::SameLine();
    const bool cancelled = ImGui::Button(context.text(UiText::cancel));
    if (use_.writes && replaces_ == chosen()) {
      ImGui::SameLine();
      ImGui::TextColored(context.colours().warning, "%s", context.text(UiText::replace_question));
    }
    if (!why.empty()) coloured_text(context.colours().refused, why.c_str());
    if (shows_losses) draw_losses(context);
    if (accepted) accept(context);
    if (cancelled) context.run("panel none");
  }

  // What was to follow a save is given up with it.
  void closed(PanelContext& context) override {
    if (is_awaited(context)) context.state.pending.reset();
  }

  ImVec2 size() const override { return {640, 460}; }

 private:
  fs::path chosen() const { return folder_ / without_tilde(name_); }

  void begin(const Document& document) {
    replaces_.clear();
    loses_.clear();
    failed_.clear();
    entered_s_ = never_s;
    std::error_code ignored;
    const fs::path& path = document.path();
    name_ = use_.writes && !use_.is_whole ? "" : path.filename().string();
    takes_keys_ = true;
    enter(path.empty() ? fs::current_path(ignored) : fs::absolute(path, ignored).parent_path());
  }

  void enter(const fs::path& folder) {
    folder_ = folder.lexically_normal();
    if (!folder_.has_filename() && folder_.has_relative_path()) folder_ = folder_.parent_path();  // a slash at its end
    entries_ = entries_of_folder(folder_, [&](const fs::path& file) { return is_listed(file); });
  }

  // What is read is chosen in each folder anew; what is written keeps the name that it was given.
  void go_to(const fs::path& folder) {
    if (!use_.writes) name_.clear();
    enter(folder);
  }

  // Files of known formats, to save as of those that can be written.
  bool is_listed(const fs::path& file) const {
    return may_be_mesh(file) && (!use_.writes || format_of_extension(file)->write);
  }

  // A click takes the name or enters the folder, a double click takes the file itself. True when a file was double
  // clicked.
  bool draw_entries(PanelContext& context) {
    bool is_chosen = false;
    fs::path next;
    if (ImGui::IsMouseClicked(0)) pressed_s_ = ImGui::GetTime();
    const bool was_entered = pressed_s_ > entered_s_ + ImGui::GetIO().MouseDoubleClickTime;
    for (const FolderEntry& entry : entries_) {
      const std::string label = entry.name + (entry.is_folder ? "/" : "");
      const bool is_named = label == name_ || entry.name == name_;
      const ImVec2 at = ImGui::GetCursorScreenPos();
      ImGui::PushID(label.c_str());
      const bool is_pressed =
          marked_row(context, is_named, ImGui::GetTextLineHeight(), ImGuiSelectableFlags_AllowDoubleClick);
      ImGui::PopID();
      const ImU32 colour =
          entry.is_folder ? ImGui::GetColorU32(context.colours().accent) : ImGui::GetColorU32(ImGuiCol_Text);
      ImGui::GetWindowDrawList()->AddText({at.x + 8 * context.scale, at.y}, colour, label.c_str());
      if (is_named && std::exchange(shows_chosen_, false)) ImGui::SetScrollHereY();
      if (is_pressed && was_entered) {
        if (entry.is_folder) {
          next = folder_ / entry.name;
        } else {
          name_ = entry.name;
          is_chosen = ImGui::IsMouseDoubleClicked(0);
        }
      }
    }
    if (!next.empty()) {
      go_to(next);
      entered_s_ = ImGui::GetTime();
    }
    return is_chosen;
  }

  // True where the name was entered.
  bool draw_name(PanelContext& context) {
    if (std::exchange(takes_keys_, false) || is_left_alone("##name")) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1);
    const bool entered = ImGui::InputTextWithHint(
        "##name",
        use_.writes ? context.text("File name; OBJ where it has no ending", "ファイル名（拡張子がなければ OBJ）")
                    : context.text(UiText::file_name),
        &name_,
        ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll |
            ImGuiInputTextFlags_CallbackCompletion | ImGuiInputTextFlags_CallbackHistory,
        &FileBrowser::edit, this);
    takes_keys_ = takes_keys_ || entered;
    if (std::exchange(goes_on_, false)) give_keyboard_to_next();
    return entered;
  }

  static int edit(ImGuiInputTextCallbackData* data) {
    static_cast<FileBrowser*>(data->UserData)->follow_keys(*data);
    return 0;
  }

  void follow_keys(ImGuiInputTextCallbackData& data) {
    const auto put = [&](const std::string& name) {
      data.DeleteChars(0, data.BufTextLen);
      data.InsertChars(0, name.c_str());
    };
    const std::string typed(data.Buf, static_cast<std::size_t>(data.BufTextLen));
    if (data.EventFlag == ImGuiInputTextFlags_CallbackCompletion) {
      const auto is_folder = [&](const std::string& path) {
        std::error_code ignored;
        return path.ends_with('/') && fs::is_directory(folder_ / without_tilde(path), ignored);
      };
      const std::string path =
          is_folder(typed) ? typed
                           : completed_path(typed, folder_, [&](const fs::path& file) { return is_listed(file); });
      goes_on_ = path == typed && !is_folder(path);
      if (goes_on_) return;
      if (!is_folder(path)) return put(path);
      enter(folder_ / without_tilde(path));  // its files are listed, and the name goes on there
      return put("");
    }
    if (data.EventFlag != ImGuiInputTextFlags_CallbackHistory || entries_.empty()) return;
    const auto at = std::find_if(entries_.begin(), entries_.end(), [&](const FolderEntry& entry) {
      return entry.name == typed || entry.name + "/" == typed;
    });
    const auto now = at - entries_.begin(), last = std::ssize(entries_) - 1;
    const bool is_down = data.EventKey == ImGuiKey_DownArrow;
    const auto next = now > last ? (is_down ? 0 : last) : std::clamp<std::ptrdiff_t>(now + (is_down ? 1 : -1), 0, last);
    const FolderEntry& entry = entries_[static_cast<std::size_t>(next)];
    put(entry.name + (entry.is_folder ? "/" : ""));
    shows_chosen_ = true;
  }

  // What the file would not hold, which the next press accepts.
  void draw_losses(PanelContext& context) const {
    for (const Message& loss : losses_) {
      ImGui::PushStyleColor(ImGuiCol_Text, context.colours().warning);
      ImGui::TextWrapped("%s", loss.text.in(context.language()).c_str());
      ImGui::PopStyleColor();
    }
    if (!losses_.empty()) ImGui::TextColored(context.colours().warning, "%s", context.text(UiText::loss_question));
  }

  void accept(PanelContext& context) {
    const fs::path path = chosen();
    if (name_.empty()) return;
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) {
      name_.clear();
      return enter(path);
    }
    if (use_.replaces && context.document().is_modified() && fs::exists(path, ignored))
      return context.leave({false, path});
    if (use_.writes && path.extension().empty()) {  // as the file that is open
      const std::string usual = context.document().path().extension().string();
      name_ += usual.empty() ? ".obj" : usual;
      return accept(context);
    }
    const std::string line = std::string(use_.command) + " " + file_argument(path.string());
    if (!use_.writes) return carry_out(context, line);
    const bool replaces = fs::exists(path, ignored) && path != replaces_;
    if (replaces) replaces_ = path;
    bool loses = false;
    if (use_.is_whole && path != loses_) {
      losses_ = context.document().losses(path);
      loses = !losses_.empty();
      loses_ = path;
    }
    if (replaces || loses) return;
    carry_out(context, line);
  }

  // Closes the panel, or keeps it open with the reason.
  void carry_out(PanelContext& context, const std::string& line) {
    const Outcome outcome = context.run(line);
    failed_ = outcome.done() ? fs::path() : chosen();
    why_failed_ = outcome.sentence;
    if (!outcome.done()) return;
    context.layout.open_panel.clear();
    if (is_awaited(context)) context.go(*context.state.pending);
  }

  // Something is to follow once the mesh has been saved here.
  bool is_awaited(const PanelContext& context) const {
    return use_.is_whole && context.state.pending && context.state.pending->awaits_name;
  }

  FileUse use_;
  fs::path folder_;
  std::vector<FolderEntry> entries_;
  std::string name_;
  bool takes_keys_ = false;    // the field is to have the keyboard
  bool goes_on_ = false;       // from the field, by Tab
  bool shows_chosen_ = false;  // the list is to show the entry of this name
  // What the next press of the button does all the same: replace this existing file, lose this in this file.
  fs::path replaces_, loses_;
  std::vector<Message> losses_;
  // Why this file could not be opened or saved.
  fs::path failed_;
  Text why_failed_;
  // When a click entered this folder, and when the button went down last, in seconds: the second press of a double
  // click on a folder is none on what is listed after the first.
  double entered_s_ = never_s, pressed_s_ = 0;
  static constexpr double never_s = -1e9;
};

}  // namespace

std::unique_ptr<Panel> make_open_panel() { return std::make_unique<FileBrowser>(to_open); }
std::unique_ptr<Panel> make_append_panel() { return std::make_unique<FileBrowser>(to_append); }
std::unique_ptr<Panel> make_compare_panel() { return std::make_unique<FileBrowser>(to_compare); }
std::unique_ptr<Panel> make_save_panel() { return std::make_unique<FileBrowser>(to_save); }
std::unique_ptr<Panel> make_save_selected_panel() { return std::make_unique<FileBrowser>(to_save_selected); }

}  // namespace ryosen
