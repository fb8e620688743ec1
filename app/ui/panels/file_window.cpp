#include <algorithm>

#include "app/editor/words.h"
#include "app/ui/panels/all.h"
#include "app/ui/widgets.h"
#include "core/io/formats.h"
// clang-format off
#include <imgui_stdlib.h>  // needs imgui.h before it
// clang-format on

namespace ryosen {

namespace {

namespace fs = std::filesystem;

// Folders and the files of known formats; hidden ones are left out.
void read_folder(FileBrowser& browser) {
  browser.entries.clear();
  std::error_code error;
  fs::directory_iterator entries(browser.folder, error);
  for (; !error && entries != fs::directory_iterator(); entries.increment(error)) {
    std::error_code ignored;
    const std::string name = entries->path().filename().string();
    if (name.starts_with('.')) continue;
    const bool is_folder = entries->is_directory(ignored);
    if (is_folder || may_be_mesh(entries->path())) browser.entries.push_back({name, is_folder});
  }
  std::sort(browser.entries.begin(), browser.entries.end(),
            [](const auto& a, const auto& b) { return a.is_folder != b.is_folder ? a.is_folder : a.name < b.name; });
}

void begin(PanelContext& context) {
  FileBrowser& browser = context.state.browser;
  if (browser.is_open) return;
  browser.is_open = true;
  browser.replaces.clear();
  browser.loses.clear();
  std::error_code ignored;
  const fs::path& path = context.session.document().path();
  browser.folder = path.empty() ? fs::current_path(ignored) : fs::absolute(path, ignored).parent_path();
  browser.name = path.filename().string();
  read_folder(browser);
}

void enter(FileBrowser& browser, const fs::path& folder) {
  browser.folder = folder;
  read_folder(browser);
}

// A click takes the name, a double click the file itself. True when a file was double clicked.
bool draw_entries(PanelContext& context) {
  FileBrowser& browser = context.state.browser;
  bool chosen = false;
  fs::path next;
  for (const FileBrowser::Entry& entry : browser.entries) {
    const std::string label = entry.name + (entry.is_folder ? "/" : "");
    if (entry.is_folder) ImGui::PushStyleColor(ImGuiCol_Text, context.colours().accent);
    if (ImGui::Selectable(label.c_str(), entry.name == browser.name, ImGuiSelectableFlags_AllowDoubleClick)) {
      if (entry.is_folder) {
        next = browser.folder / entry.name;
      } else {
        browser.name = entry.name;
        chosen = ImGui::IsMouseDoubleClicked(0);
      }
    }
    if (entry.is_folder) ImGui::PopStyleColor();
  }
  if (!next.empty()) enter(browser, next);
  return chosen;
}

// What the file would not hold, which the next press accepts.
void draw_losses(PanelContext& context) {
  for (const Message& loss : context.state.browser.losses) {
    ImGui::PushStyleColor(ImGuiCol_Text, context.colours().warning);
    ImGui::TextWrapped("%s", loss.text.in(context.language()).c_str());
    ImGui::PopStyleColor();
  }
  if (!context.state.browser.losses.empty())
    ImGui::TextColored(context.colours().warning, "%s", context.text(UiText::loss_question));
}

void accept(PanelContext& context, bool saves) {
  FileBrowser& browser = context.state.browser;
  const fs::path path = browser.folder / browser.name;
  if (browser.name.empty()) return;
  if (!saves) return context.leave({false, path});
  std::error_code ignored;
  const bool replaces = fs::exists(path, ignored) && path != browser.replaces;
  if (replaces) browser.replaces = path;
  bool loses = false;
  if (path != browser.loses) {
    browser.losses = context.session.document().losses(path);
    loses = !browser.losses.empty();
    browser.loses = path;
  }
  if (replaces || loses) return;
  if (context.run("save " + file_argument(path.string())).done()) context.session.open_panel.clear();
}

}  // namespace

void draw_file_window(PanelContext& context) {
  const bool saves = context.session.open_panel == "save", opens = context.session.open_panel == "open";
  if (!saves && !opens) context.state.browser.is_open = false;
  for (const char* id : {"open", "save"}) {
    if (context.session.open_panel == id) begin(context);
    const char* const title = context.text(id == std::string_view("open") ? UiText::open : UiText::save_as);
    if (!begin_over(context, id, title, {640, 460})) continue;
    FileBrowser& browser = context.state.browser;
    if (ImGui::Button(context.text(UiText::folder_up))) enter(browser, browser.folder.parent_path());
    ImGui::SameLine();
    ImGui::TextColored(context.colours().dim, "%s", browser.folder.c_str());
    const bool shows_losses = saves && browser.loses == browser.folder / browser.name && !browser.losses.empty();
    const float rows = 2.0f + (shows_losses ? 1.0f + 1.5f * static_cast<float>(browser.losses.size()) : 0.0f);
    const float below = std::min(rows, 10.0f) * ImGui::GetFrameHeightWithSpacing();
    ImGui::BeginChild("entries", {0, -below}, true);
    bool accepted = draw_entries(context);
    ImGui::EndChild();
    ImGui::SetNextItemWidth(-1);
    accepted |= ImGui::InputTextWithHint("##name", context.text(UiText::file_name), &browser.name,
                                         ImGuiInputTextFlags_EnterReturnsTrue);
    accepted |= ImGui::Button(title);
    ImGui::SameLine();
    const bool cancelled = ImGui::Button(context.text(UiText::cancel));
    if (saves && browser.replaces == browser.folder / browser.name) {
      ImGui::SameLine();
      ImGui::TextColored(context.colours().warning, "%s", context.text(UiText::replace_question));
    }
    if (saves && browser.loses == browser.folder / browser.name) draw_losses(context);
    end_over();
    if (accepted) accept(context, saves);
    if (cancelled) context.run("panel none");
  }
}

}  // namespace ryosen
