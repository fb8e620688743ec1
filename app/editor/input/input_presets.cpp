#include "app/editor/input/input_presets.h"

#include <algorithm>
#include <iterator>

namespace ryosen {

namespace {

using enum MouseButton;
using enum DragAction;

constexpr DragRow ryosen_drags[] = {
    {left, false, false, orbit},   {left, true, false, pan},   {left, true, true, box},     {right, false, false, pan},
    {middle, false, false, orbit}, {middle, true, false, pan}, {middle, false, true, zoom},
};
constexpr DragRow blender_drags[] = {
    {left, false, false, box},     {right, false, false, pan}, {right, false, true, lasso},
    {middle, false, false, orbit}, {middle, true, false, pan}, {middle, false, true, zoom},
};
constexpr DragRow meshlab_drags[] = {
    {left, false, false, orbit}, {left, true, false, zoom},  {left, false, true, pan},
    {left, true, true, box},     {right, false, false, pan}, {middle, false, false, pan},
};

constexpr KeyChange blender_keys[] = {
    {"S", "gesture scale", "scale the selection", "選択を拡大縮小"},
    {"Shift+S", "tool swap", "Swap edge", "稜線交換"},
    {"Alt+H", "unhide", "show what is hidden", "非表示の要素を表示する"},
    {"Alt+A", "select none", "Select nothing", "選択を解除"},
    {"Ctrl+I", "select invert", "Select the others instead", "選択を反転"},
    {"L", "select linked", "Select all that is linked", "つながる全体を選択"},
    {"Ctrl+L", "select linked", "Select all that is linked", "つながる全体を選択"},
    {"Ctrl++", "select grow", "Select the neighbours too", "選択を隣へ広げる"},
    {"Ctrl+-", "select shrink", "Leave out the outermost", "選択を縁から縮める"},
};

struct GestureHelp {
  DragAction action;
  std::string_view help_en, help_ja;
};

constexpr GestureHelp gesture_helps[] = {
    {orbit, "orbit", "回転"},
    {pan, "pan", "視点の平行移動"},
    {zoom, "zoom", "拡大"},
    {box, "select by a box", "ボックスで選択"},
    {lasso, "select by a lasso", "投げ縄で選択"},
};

constexpr struct {
  std::string_view input_en, input_ja, does_en, does_ja;
} clicks[] = {
    {"click", "クリック", "select; with a tool, edit", "選択（ツールでは編集）"},
    {"Shift+click", "Shift+クリック", "add to the selection", "選択に追加"},
    {"Ctrl+click", "Ctrl+クリック", "add, or take out what is selected", "選択に追加、選択済みなら解除"},
    {"Alt+click", "Alt+クリック", "select the loop of the nearest edge", "最寄りの稜線のループを選択"},
    {"Ctrl+Alt+click", "Ctrl+Alt+クリック", "select the ring of the nearest edge", "最寄りの稜線のリングを選択"},
    {"double click", "ダブルクリック", "set the centre, with Select", "選択ツールで中心を決める"},
    {"right click", "右クリック", "the menu of the element", "要素のメニュー"},
    {"wheel", "ホイール", "zoom to the pointer", "ポインタへ拡大・縮小"},
};

constexpr InputPreset presets[] = {
    {"ryosen", "Mouse as in Ryosen", "マウス操作：Ryosen", ryosen_drags, {}},
    {"blender", "Mouse as in Blender", "マウス操作：Blender", blender_drags, blender_keys},
    {"meshlab", "Mouse as in MeshLab", "マウス操作：MeshLab", meshlab_drags, {}},
};

}  // namespace

std::span<const InputPreset> input_presets() { return presets; }

DragAction drag_action_of(const InputPreset& preset, MouseButton button, Modifiers modifiers) {
  const DragRow* alone = nullptr;
  for (const DragRow& row : preset.drags) {
    if (row.button != button) continue;
    if (row.shift == modifiers.shift && row.ctrl == modifiers.ctrl) return row.action;
    if (!row.shift && !row.ctrl) alone = &row;
  }
  return alone->action;
}

// The same in every preset.
ClickSelects click_selects(Modifiers modifiers) {
  if (!modifiers.alt) return ClickSelects::element;
  return modifiers.ctrl ? ClickSelects::ring : ClickSelects::loop;
}

Text help_of(DragAction action) {
  const auto row = std::find_if(std::begin(gesture_helps), std::end(gesture_helps),
                                [&](const GestureHelp& help) { return help.action == action; });
  return {std::string(row->help_en), std::string(row->help_ja)};
}

Text name_of(const DragRow& drag) {
  const std::string held = std::string(drag.ctrl ? "Ctrl+" : "") + (drag.shift ? "Shift+" : "");
  return {held +
              (drag.button == left    ? "left"
               : drag.button == right ? "right"
                                      : "middle") +
              " drag",
          held +
              (drag.button == left    ? "左"
               : drag.button == right ? "右"
                                      : "中") +
              "ドラッグ"};
}

std::vector<MouseRow> mouse_table(const InputPreset& preset) {
  std::vector<MouseRow> rows;
  for (const DragRow& drag : preset.drags) {
    Text does = help_of(drag.action);
    if (selects(drag.action)) does = {does.en + "; Alt goes through", does.ja + "（Alt で裏側も）"};
    rows.push_back({name_of(drag), std::move(does)});
  }
  for (const auto& click : clicks)
    rows.push_back({{std::string(click.input_en), std::string(click.input_ja)},
                    {std::string(click.does_en), std::string(click.does_ja)}});
  return rows;
}

}  // namespace ryosen
