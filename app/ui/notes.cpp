// What lies over the view and waits for an answer, without keeping anybody from working.
#include <cmath>

#include "app/editor/document/findings.h"
#include "app/editor/session/session.h"
#include "app/ui/panels.h"
#include "app/ui/widgets.h"

namespace ryosen {

namespace {

template <class Content>
void draw_note(PanelContext& context, const char* id, ImVec2 at, ImVec2 pivot, Content content) {
  ImGui::SetNextWindowPos(at, 0, pivot);
  ImGui::Begin(id, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoBringToFrontOnFocus |
                   ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoMove);
  ImGui::AlignTextToFramePadding();
  content();
  const ImVec2 from = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  context.state.notes.push_back({static_cast<int>(from.x), static_cast<int>(from.y), static_cast<int>(from.x + size.x),
                                 static_cast<int>(from.y + size.y)});
  ImGui::End();
}

void draw_hidden(PanelContext& context, ImVec2 bottom) {
  if (context.findings().hidden().empty()) return;
  draw_note(context, "##hidden", bottom, {0.5f, 1}, [&] {
    ImGui::TextUnformatted(hidden_text(context.findings().hidden()).in(context.language()).c_str());
    ImGui::SameLine();
    if (ImGui::Button(context.text(UiText::unhide))) context.run("unhide");
    tip(context.text("Shows again what is hidden.", "非表示にした要素をすべて表示します。") + std::string(" ") +
        chord_of(context.preferences, "unhide"));
  });
}

void draw_change_on_disk(PanelContext& context, ImVec2 top) {
  const FileState::Change change = context.session.change_on_disk();
  if (change == FileState::Change::none) return;
  const bool is_gone = change == FileState::Change::gone;
  const std::string name = context.document().path().filename().string();
  draw_note(context, "##disk", top, {0.5f, 0}, [&] {
    ImGui::TextUnformatted((name + (is_gone ? context.text(" is gone from the disk.", " がディスクからなくなりました。")
                                            : context.text(" has changed on disk.", " がディスク上で変更されました。")))
                               .c_str());
    ImGui::SameLine();
    if (!is_gone) {
      if (ImGui::Button(context.text("Reload", "読み直す"))) context.run("reload");
      tip(context.text("Reads the file again. Edits that are not saved are lost, after a question.",
                       "ファイルを読み直します。保存していない編集は、確認のあとで失われます。"));
      ImGui::SameLine();
    }
    if (ImGui::Button(context.text("Keep mine", "こちらを残す"))) context.run("keep_mine");
    tip(context.text("Goes on with the mesh as it is here; saving writes the file anew.",
                     "このままのメッシュで続けます。保存するとファイルを書き直します。"));
  });
}

// Which of two meshes beside each other is which: both may be of the same file.
std::string name_beside(const PanelContext& context, const Document& document) {
  const std::string name = document.path().filename().string();
  const std::string faces = grouped(document.mesh().live().faces);
  const char* const edited = document.is_modified() ? context.text(", edited", "（編集中）") : "";
  return name + edited + ": " + Text{faces + " faces", "面 " + faces}.in(context.language());
}

void draw_names(PanelContext& context) {
  const Compared* const compared = context.session.compared();
  if (!compared) return;
  using Half = std::pair<const Document&, const ViewState&>;
  for (const auto& [document, view] :
       {Half(context.document(), context.view), Half(compared->document(), compared->state())}) {
    const std::string name = name_beside(context, document);
    const float margin = 8 * context.scale, gap = 3 * context.scale;
    const ImVec2 at{static_cast<float>(view.origin.x) + margin, static_cast<float>(view.origin.y) + margin};
    const ImVec2 size = ImGui::CalcTextSize(name.c_str());
    ImDrawList* const list = ImGui::GetBackgroundDrawList();
    list->AddRectFilled({at.x - gap, at.y - gap}, {at.x + size.x + gap, at.y + size.y + gap},
                        ImGui::GetColorU32(ImGuiCol_WindowBg), gap);
    list->AddText(at, ImGui::GetColorU32(ImGuiCol_Text), name.c_str());
  }
}

// How to go on from an empty mesh. It takes no pointer.
void draw_way_on(PanelContext& context) {
  if (!context.session.is_empty() || context.session.is_at_start()) return;
  const MenuRow& add = *find_menu("add");
  const std::string chord = chord_of(context.preferences, "menu add"), title = context.text(add.title_en, add.title_ja);
  const std::string name = chord.empty() ? title : title + " (" + chord + ")";
  const std::string lines[] = {
      Text{"The menu " + name + " makes a shape,", "メニューの「" + name + "」で基本形状を作れます。"}.in(
          context.language()),
      context.text(UiText::or_drop)};
  const float pitch = ImGui::GetTextLineHeightWithSpacing();
  const auto width = static_cast<float>(context.view.size.width), height = static_cast<float>(context.view.size.height);
  float y = static_cast<float>(context.view.origin.y) + height / 2 - pitch;
  for (const std::string& line : lines) {
    const float x = static_cast<float>(context.view.origin.x) + (width - ImGui::CalcTextSize(line.c_str()).x) / 2;
    ImGui::GetBackgroundDrawList()->AddText({std::round(x), std::round(y)}, ImGui::GetColorU32(context.colours().dim),
                                            line.c_str());
    y += pitch;
  }
}

}  // namespace

void draw_notes(PanelContext& context) {
  context.state.notes.clear();
  draw_names(context);
  draw_way_on(context);
  const auto left = static_cast<float>(context.view.origin.x), top = static_cast<float>(context.view.origin.y);
  const auto width = static_cast<float>(context.view.size.width), height = static_cast<float>(context.view.size.height);
  const float margin = 12 * context.scale;
  draw_hidden(context, {left + width / 2, top + height - margin});
  draw_change_on_disk(context, {left + width / 2, top + margin});
}

}  // namespace ryosen
