#include "app/editor/gestures.h"

#include <algorithm>
#include <iterator>

namespace ryosen {

namespace {

using enum MouseButton;
using enum Gesture;

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
    {"Alt+A", "select none", "Select nothing", "選択を解除"},
    {"Ctrl+I", "select invert", "Select the others instead", "選択を反転"},
    {"Ctrl+L", "select linked", "Select all that is linked", "つながる全体を選択"},
    {"Ctrl++", "select grow", "Select the neighbours too", "選択を隣へ広げる"},
    {"Ctrl+-", "select shrink", "Leave out the outermost", "選択を縁から縮める"},
};

constexpr InputPreset presets[] = {
    {"ryosen", "Mouse as in Ryosen", "マウス操作：稜線", ryosen_drags, {}},
    {"blender", "Mouse as in Blender", "マウス操作：Blender", blender_drags, blender_keys},
    {"meshlab", "Mouse as in MeshLab", "マウス操作：MeshLab", meshlab_drags, {}},
};

}  // namespace

std::span<const InputPreset> input_presets() { return presets; }

Gesture gesture_of(const InputPreset& preset, MouseButton button, Modifiers modifiers) {
  const DragRow* alone = nullptr;
  for (const DragRow& row : preset.drags) {
    if (row.button != button) continue;
    if (row.shift == modifiers.shift && row.ctrl == modifiers.ctrl) return row.gesture;
    if (!row.shift && !row.ctrl) alone = &row;
  }
  return alone->gesture;
}

// The same in every preset.
ClickSelects click_selects(Modifiers modifiers) {
  if (!modifiers.alt) return ClickSelects::element;
  return modifiers.ctrl ? ClickSelects::ring : ClickSelects::loop;
}

}  // namespace ryosen
