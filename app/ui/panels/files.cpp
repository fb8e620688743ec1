#include <algorithm>

#include "app/editor/words.h"
#include "app/ui/panels.h"
#include "app/ui/widgets.h"
#include "core/io/formats.h"
// clang-format off
#include <imgui_stdlib.h>  // needs imgui.h before it
// clang-format on

namespace ryosen {

namespace {

namespace fs = std::filesystem;

// A folder, what is in it, and the name in the field: of a file to open, or to save as.
class FileBrowser : public Panel {
 public:
  explicit FileBrowser(bool saves) : saves_(saves) {}
  void draw(PanelContext& context) override;
  ImVec2 size() const override { return {640, 460}; }

 private:
  struct Entry {
    std::string name;
    bool is_folder = false;
  };

  fs::path chosen() const { return folder_ / name_; }
  void begin(const Document& document);
  void enter(const fs::path& folder);
  bool draw_entries(PanelContext& context);
  void draw_losses(PanelContext& context) const;
  void accept(PanelContext& context);
  void carry_out(PanelContext& context, const std::string& line);

  bool saves_;
  fs::path folder_;
  std::vector<Entry> entries_;  // folders first, by name
  std::string name_;
  // What the next press of the button does all the same: replace this existing file, lose this in this file.
  fs::path replaces_, loses_;
  std::vector<Message> losses_;
  // Why this file could not be opened or saved.
  fs::path failed_;
  Text why_failed_;
  // When a click entered this folder, and when the button went down last, in seconds: the second press of a double click on
  // a folder is none on what is listed after the first.
  double entered_s_ = never_s, pressed_s_ = 0;
  static constexpr double never_s = -1e9;
};

void FileBrowser::begin(const Document& document) {
  replaces_.clear();
  loses_.clear();
  failed_.clear();
  entered_s_ = never_s;
  std::error_code ignored;
  const fs::path& path = document.path();
  name_ = path.filename().string();
  enter(path.empty() ? fs::current_path(ignored) : fs::absolute(path, ignored).parent_path());
}

// Folders and the files of known formats, to save as of those that can be written; hidden ones are left out.
void FileBrowser::enter(const fs::path& folder) {
  folder_ = folder;
  entries_.clear();
  std::error_code error;
  fs::directory_iterator entries(folder_, error);
  for (; !error && entries != fs::directory_iterator(); entries.increment(error)) {
    std::error_code ignored;
    const std::string name = entries->path().filename().string();
    if (name.starts_with('.')) continue;
    const bool is_folder = entries->is_directory(ignored);
    const Format* const format = format_of_extension(entries->path());
    const bool is_listed = may_be_mesh(entries->path()) && (!saves_ || format->write);
    if (is_folder || is_listed) entries_.push_back({name, is_folder});
  }
  std::sort(entries_.begin(), entries_.end(),
            [](const auto& a, const auto& b) { return a.is_folder != b.is_folder ? a.is_folder : a.name < b.name; });
}

// A click takes the name or enters the folder, a double click takes the file itself. True when a file was double clicked.
bool FileBrowser::draw_entries(PanelContext& context) {
  bool is_chosen = false;
  fs::path next;
  if (ImGui::IsMouseClicked(0)) pressed_s_ = ImGui::GetTime();
  const bool was_entered = pressed_s_ > entered_s_ + ImGui::GetIO().MouseDoubleClickTime;
  for (const Entry& entry : entries_) {
    const std::string label = entry.name + (entry.is_folder ? "/" : "");
    if (entry.is_folder) ImGui::PushStyleColor(ImGuiCol_Text, context.colours().accent);
    if (ImGui::Selectable(label.c_str(), entry.name == name_, ImGuiSelectableFlags_AllowDoubleClick) && was_entered) {
      if (entry.is_folder) {
        next = folder_ / entry.name;
      } else {
        name_ = entry.name;
        is_chosen = ImGui::IsMouseDoubleClicked(0);
      }
    }
    if (entry.is_folder) ImGui::PopStyleColor();
  }
  if (!next.empty()) {
    enter(next);
    entered_s_ = ImGui::GetTime();
  }
  return is_chosen;
}

// What the file would not hold, which the next press accepts.
void FileBrowser::draw_losses(PanelContext& context) const {
  for (const Message& loss : losses_) {
    ImGui::PushStyleColor(ImGuiCol_Text, context.colours().warning);
    ImGui::TextWrapped("%s", loss.text.in(context.language()).c_str());
    ImGui::PopStyleColor();
  }
  if (!losses_.empty()) ImGui::TextColored(context.colours().warning, "%s", context.text(UiText::loss_question));
}

// Closes the panel, or keeps it open with the reason.
void FileBrowser::carry_out(PanelContext& context, const std::string& line) {
  const Outcome outcome = context.run(line);
  failed_ = outcome.done() ? fs::path() : chosen();
  why_failed_ = outcome.sentence;
  if (outcome.done()) context.session.open_panel.clear();
}

void FileBrowser::accept(PanelContext& context) {
  const fs::path path = chosen();
  if (name_.empty()) return;
  if (!saves_ && context.session.document().is_modified()) return context.leave({false, path});
  if (!saves_) return carry_out(context, "open " + file_argument(path.string()));
  std::error_code ignored;
  const bool replaces = fs::exists(path, ignored) && path != replaces_;
  if (replaces) replaces_ = path;
  bool loses = false;
  if (path != loses_) {
    losses_ = context.session.document().losses(path);
    loses = !losses_.empty();
    loses_ = path;
  }
  if (replaces || loses) return;
  carry_out(context, "save " + file_argument(path.string()));
}

void FileBrowser::draw(PanelContext& context) {
  if (ImGui::IsWindowAppearing()) begin(context.session.document());
  if (ImGui::Button(context.text(UiText::folder_up))) enter(folder_.parent_path());
  ImGui::SameLine();
  ImGui::PushStyleColor(ImGuiCol_Text, context.colours().dim);
  fitted_text(folder_.string(), ImGui::GetContentRegionAvail().x);
  ImGui::PopStyleColor();
  const bool shows_losses = saves_ && loses_ == chosen() && !losses_.empty();
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
  ImGui::SetNextItemWidth(-1);
  accepted |=
      ImGui::InputTextWithHint("##name", context.text(UiText::file_name), &name_, ImGuiInputTextFlags_EnterReturnsTrue);
  accepted |= ImGui::Button(context.text(saves_ ? UiText::save : UiText::open));
  ImGui::SameLine();
  const bool cancelled = ImGui::Button(context.text(UiText::cancel));
  if (saves_ && replaces_ == chosen()) {
    ImGui::SameLine();
    ImGui::TextColored(context.colours().warning, "%s", context.text(UiText::replace_question));
  }
  if (!why.empty()) coloured_text(context.colours().refused, why.c_str());
  if (shows_losses) draw_losses(context);
  if (accepted) accept(context);
  if (cancelled) context.run("panel none");
}

}  // namespace

std::unique_ptr<Panel> make_open_panel() { return std::make_unique<FileBrowser>(false); }
std::unique_ptr<Panel> make_save_panel() { return std::make_unique<FileBrowser>(true); }

}  // namespace ryosen
