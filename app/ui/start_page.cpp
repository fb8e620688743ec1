#include "app/ui/start_page.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include "app/editor/commands/commands.h"
#include "app/editor/commands/text/words.h"
#include "app/editor/session/session.h"
#include "app/ui/widgets.h"
#include "ryosen/algo/algorithm_table.h"

namespace ryosen {

namespace {

constexpr std::array<std::pair<std::string_view, int>, 5> taken_keys{{{"Up", ImGuiKey_UpArrow},
                                                                      {"Down", ImGuiKey_DownArrow},
                                                                      {"Left", ImGuiKey_LeftArrow},
                                                                      {"Right", ImGuiKey_RightArrow},
                                                                      {"Enter", ImGuiKey_Enter}}};

// The drag that does this in the preset, alone if there is one.
std::string drag_for(const PanelContext& context, DragAction action) {
  const InputPreset& preset = input_presets()[context.preferences.input_preset];
  const auto row = std::find_if(preset.drags.begin(), preset.drags.end(), [&](const DragRow& drag) {
    return drag.action == action && !drag.shift && !drag.ctrl;
  });
  return row == preset.drags.end() ? "" : name_of(*row).in(context.language());
}

std::vector<std::string> hints_of_start(const PanelContext& context) {
  const bool ja = context.language() == Language::japanese;
  const std::string orbit = drag_for(context, DragAction::orbit), pan = drag_for(context, DragAction::pan),
                    undo = chord_of(context.preferences, "undo"), save = chord_of(context.preferences, "save"),
                    collapse = chord_of(context.preferences, "tool collapse"),
                    split = chord_of(context.preferences, "tool split"),
                    move = chord_of(context.preferences, "gesture move");
  const std::string look = ja ? "見る：" + orbit + "で回し、" + pan + "で動かし、ホイールで拡大します。"
                              : "Look: " + orbit + " turns, " + pan + " moves, the wheel zooms.";
  const std::string edit =
      ja ? "編集：" + collapse + "（稜線削除）や " + split +
               "（辺細分）を押し、稜線を指すと結果が見え、クリックで実行します。"
         : "Edit: press " + collapse + " to collapse or " + split + " to split, point at an edge and click.";
  const std::string moving =
      ja ? "動かす：Esc で道具を置き、クリックで選び、矢印をドラッグするか、" + move +
               " を押してから動かしてクリックします。"
         : "Move: Esc puts the tool away; click, drag an arrow or press " + move + ", move, click.";
  const std::string take_back = ja ? "戻す：" + undo + "（正確に元へ戻ります）。保存：" + save + "。"
                                   : "Undo: " + undo + " takes back every edit exactly. Save: " + save + ".";
  return {look, edit, moving, take_back};
}

void draw_hints(PanelContext& context) {
  for (const std::string& hint : hints_of_start(context)) dim_text(context, hint.c_str());
}

}  // namespace

bool StartPage::takes(std::string_view chord) {
  return std::any_of(taken_keys.begin(), taken_keys.end(), [&](const auto& key) { return key.first == chord; });
}

void StartPage::entry(PanelContext& context, const std::string& name, const std::string& line, bool fills) {
  ImGui::PushID(static_cast<int>(entries_.size()));
  ImGui::BeginDisabled(line.empty());
  ImGui::PushStyleVar(ImGuiStyleVar_ButtonTextAlign, {fills ? 0.f : 0.5f, 0.5f});
  const float room = ImGui::GetContentRegionAvail().x;
  const std::string label = fills ? fitted(name, room - 2 * ImGui::GetStyle().FramePadding.x) : name;
  if (ImGui::Button(label.c_str(), {fills ? room : 0, 0})) taken_ = line;
  ImGui::PopStyleVar();
  ImGui::EndDisabled();
  entries_.push_back({line, ImGui::GetItemRectMin(), ImGui::GetItemRectMax()});
  mark_focus(context);
  ImGui::PopID();
}

void StartPage::mark_focus(PanelContext& context) const {
  if (!has_keys_ || focus_ + 1 != entries_.size()) return;
  ImGui::GetWindowDrawList()->AddRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
                                      ImGui::GetColorU32(context.colours().accent), 4 * context.scale, 0,
                                      2 * context.scale);
  ImGui::SetScrollHereY();
}

bool StartPage::is_shown(const Session& session) { return session.is_at_start() && session.layout.open_panel.empty(); }

void StartPage::look_for_recent(const std::vector<std::string>& files) {
  const bool is_known = std::equal(files.begin(), files.end(), recent_.begin(), recent_.end(),
                                   [](const std::string& file, const auto& known) { return file == known.first; });
  if (is_known) return;
  recent_.clear();
  std::error_code ignored;
  for (const std::string& file : files) recent_.emplace_back(file, std::filesystem::is_regular_file(file, ignored));
}

void StartPage::draw_recent(PanelContext& context, std::size_t most) {
  look_for_recent(context.preferences.recent);
  if (recent_.empty() || most == 0) return;
  bold_text(context, context.text("Recent files", "最近のファイル"));
  for (const auto& [file, is_there] : std::span(recent_).first(std::min(most, recent_.size()))) {
    const std::string name = std::filesystem::path(file).filename().string();
    const std::string gone = context.text(" (not there any more)", "（見つかりません）");
    entry(context, is_there ? name : name + gone, is_there ? "open " + file_argument(file) : "", true);
    tip(is_there ? file : file + gone, ImGuiHoveredFlags_AllowWhenDisabled);
  }
}

void StartPage::draw_beginnings(PanelContext& context, std::size_t most_recent) {
  entry(context, context.text("New, an empty mesh", "新規（空のメッシュ）"), "new", true);
  entry(context, context.text("Open...", "開く..."), "panel open", true);
  dim_text(context, context.text(UiText::or_drop));
  draw_recent(context, most_recent);
}

// As many in a line as there is room for.
void StartPage::draw_shapes(PanelContext& context) {
  bold_text(context, context.text("A shape", "基本形状"));
  const float end = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  bool is_first = true;
  for (const AlgorithmRow& row : algorithm_table()) {
    if (!row.is_primitive) continue;
    const std::string name = context.text(row.name_en, row.name_ja);
    const float width = ImGui::CalcTextSize(name.c_str()).x + 2 * ImGui::GetStyle().FramePadding.x;
    const bool fits = ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x + width <= end;
    if (!std::exchange(is_first, false) && fits) ImGui::SameLine();
    entry(context, name, called(row), false);
    tip(context.text(row.help_en, row.help_ja));
  }
}

void StartPage::take(const Entry& entry) {
  taken_ = entry.line;
  part_ = entry.opens.value_or(part_);
}

// To the nearest entry in the direction, by what is drawn.
void StartPage::follow_keys() {
  const ImVec2 steps[] = {{0, -1}, {0, 1}, {-1, 0}, {1, 0}};
  const auto middle = [](const Entry& e) { return ImVec2((e.first.x + e.last.x) / 2, (e.first.y + e.last.y) / 2); };
  focus_ = std::min(focus_, entries_.size() - 1);
  for (std::size_t k = 0; k < taken_keys.size(); ++k) {
    if (!ImGui::IsKeyPressed(taken_keys[k].second)) continue;
    if (k == 4) return has_keys_ ? take(entries_[focus_]) : void();
    if (!std::exchange(has_keys_, true)) return;  // the first press shows where it is
    const ImVec2 from = middle(entries_[focus_]);
    float nearest = 0;
    std::size_t found = focus_;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      const ImVec2 at = middle(entries_[i]), by(at.x - from.x, at.y - from.y);
      const float along = by.x * steps[k].x + by.y * steps[k].y;
      const float aside = std::abs(by.x * steps[k].y) + std::abs(by.y * steps[k].x);
      if (along < 4 || (entries_[i].line.empty() && !entries_[i].opens)) continue;
      const float cost = along + (k < 2 ? 0.3f : 3.f) * aside;
      if (found != focus_ && cost >= nearest) continue;
      found = i;
      nearest = cost;
    }
    focus_ = found;
  }
}

void StartPage::draw_whole(PanelContext& context) {
  if (ImGui::BeginTable("ways", 2, ImGuiTableFlags_SizingStretchSame)) {
    ImGui::TableNextColumn();
    draw_beginnings(context, recent_.max_size());
    ImGui::TableNextColumn();
    draw_shapes(context);
    draw_exercises(context);
    ImGui::EndTable();
  }
  draw_figures(context);
  ImGui::Separator();
  draw_hints(context);
}

// The hints keep their place at the bottom, whatever part is shown.
void StartPage::draw_tabs(PanelContext& context, float height) {
  const struct {
    Part part;
    const char* name;
  } tabs[] = {{Part::beginnings, context.text("Files", "ファイル")},
              {Part::shapes, context.text("Shapes", "基本形状")},
              {Part::exercises, context.text("Exercises", "演習")},
              {Part::figures, context.text("Figures", "図")}};
  for (const auto& [part, name] : tabs) {
    if (part != tabs[0].part) ImGui::SameLine();
    const bool is_shown = part == part_;
    ImGui::PushStyleColor(ImGuiCol_Button,
                          ImGui::GetStyleColorVec4(is_shown ? ImGuiCol_ButtonActive : ImGuiCol_Header));
    const bool is_taken = ImGui::Button(name);
    ImGui::PopStyleColor();
    entries_.push_back({{}, ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), part});
    mark_focus(context);
    if (is_taken) take(entries_.back());
  }
  const float width = ImGui::GetContentRegionAvail().x, gap = ImGui::GetStyle().ItemSpacing.y;
  float hints = ImGui::GetStyle().WindowPadding.y + 2 * gap;
  for (const std::string& hint : hints_of_start(context)) hints += wrapped_size(hint, width).y + gap;
  const float room = height - hints - ImGui::GetCursorPosY(), row = ImGui::GetFrameHeightWithSpacing();
  const float recent = room - 2 * row - 2 * ImGui::GetTextLineHeightWithSpacing();
  if (part_ == Part::beginnings) draw_beginnings(context, static_cast<std::size_t>(std::max(recent / row, 0.f)));
  if (part_ == Part::shapes) draw_shapes(context);
  if (part_ == Part::exercises) draw_exercises(context);
  if (part_ == Part::figures) draw_figures(context);
  ImGui::SetCursorPosY(std::max(height - hints, ImGui::GetCursorPosY()));
  ImGui::Separator();
  draw_hints(context);
}

void StartPage::draw(PanelContext& context) {
  if (!is_shown(context.session)) {
    has_keys_ = false;
    focus_ = 0;
    recent_.clear();  // it is looked for them anew when this is shown again
    return;
  }
  const float margin = 8 * context.scale;
  const ImVec2 room(static_cast<float>(context.view.size.width) - 2 * margin,
                    static_cast<float>(context.view.size.height) - 2 * margin);
  const float width = std::min(room.x, 40 * ImGui::GetFontSize());
  ImGui::SetNextWindowPos({static_cast<float>(context.view.origin.x) + margin + room.x / 2,
                           static_cast<float>(context.view.origin.y) + margin + room.y / 2},
                          0, {0.5f, 0.5f});
  ImGui::SetNextWindowSizeConstraints({width, 0}, {width, room.y});
  ImGui::Begin("##start", nullptr,
               (ImGuiWindowFlags_NoDecoration & ~ImGuiWindowFlags_NoScrollbar) | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                   ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoMove);
  entries_.clear();
  taken_.clear();
  const Measured now{width, ImGui::GetFontSize(), context.language(), context.preferences.recent.size()};
  const bool is_known = measured_ == now;
  bold_text(context, context.text("Ryosen: where do you want to begin?", "稜線：何から始めますか"));
  if (is_known && whole_height_ > room.y)
    draw_tabs(context, room.y);
  else
    draw_whole(context);
  if (!is_known || whole_height_ <= room.y) whole_height_ = ImGui::GetCursorPosY() + ImGui::GetStyle().WindowPadding.y;
  if (!is_known) context.state.unsettle();
  measured_ = now;
  const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  context.state.notes.push_back({static_cast<int>(at.x), static_cast<int>(at.y), static_cast<int>(at.x + size.x),
                                 static_cast<int>(at.y + size.y)});
  if (!context.state.menus.had_keys) follow_keys();
  ImGui::End();
  if (!taken_.empty()) context.run(taken_);
}

}  // namespace ryosen
